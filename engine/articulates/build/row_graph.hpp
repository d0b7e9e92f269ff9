#pragma once
// Which rows of an articulate meet, and so have a block of the matrix in common.
#include <cstdint>
#include <vector>

#include "articulates/build/edges.hpp"
#include "articulates/factor.hpp"

namespace pantin {

/// Nodes with many rows to nodes of few, which meet at variables of the node: no coupled ones, since rows of one coupling meet each other.
std::vector<std::uint32_t> find_hubs(const std::vector<Edge>& edges, const RowLists& rows_on);

/// Which rows meet: at a node, at the two variables of a hub, which follow the rows, or as rows of a coupling.
RowLists neighbours_of(const std::vector<Edge>& edges, const RowLists& rows_on, const std::vector<std::uint32_t>& hubs);

}  // namespace pantin
