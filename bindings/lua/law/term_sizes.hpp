#pragma once
// How large the terms are that add up to an expression: what its round-off is measured by.
#include <functional>
#include <span>
#include <vector>

#include "laws/expression.hpp"

namespace pantin::lua {

/// Value of an input of sample k.
using InputValue = std::function<double(const Input&, int k)>;

/// (outputs × n) values of some expressions, by the program that laws run, n <= Machine::block.
std::vector<std::vector<double>> run_expressions(const Expressions& graph, std::span<const Expr> outputs, int n,
                                                 const InputValue& value);

/// (outputs × n) sizes: |value| and what cancelled on the way to it, times what was done to it since. Infinite where a
/// condition or a floor is undecided within round-off.
std::vector<std::vector<double>> term_sizes(const Expressions& graph, std::span<const Expr> outputs, int n,
                                            const InputValue& value);

}  // namespace pantin::lua
