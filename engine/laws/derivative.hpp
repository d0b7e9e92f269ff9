#pragma once
#include <span>
#include <vector>

#include "laws/expression.hpp"

namespace pantin {

/// d e / d x by forward mode on the shared graph, as an expression of the same graph. `x` is an input.
Expr derivative(Expressions& graph, Expr e, const Input& x);
/// d e / d x for each x by reverse mode: one pass over the graph, however many there are.
std::vector<Expr> gradient(Expressions& graph, Expr e, std::span<const Input> xs);

}  // namespace pantin
