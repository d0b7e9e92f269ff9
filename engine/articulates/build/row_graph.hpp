#pragma once
// Which rows of an articulate meet, and so have a block of the matrix in common.
#include <cstdint>
#include <vector>

#include "articulates/build/edges.hpp"
#include "articulates/factor.hpp"

namespace pantin {

/// A node with many rows, which meet at variables of its own: one of how far they shift it, and one of how far they turn it
/// where it is a body.
struct HubNode {
  std::uint32_t node, variable;  ///< the first of them, counted from the last row on
  bool is_body;
  std::uint32_t count() const { return is_body ? 2 : 1; }  ///< of its variables
};

/// Nodes with many rows that are soft or lead to nodes of few; none with coupled ones, since rows of one coupling meet each
/// other. In an order in which what is left once the rows are gone is eliminated at little cost. `is_body` (nodes).
std::vector<HubNode> find_hubs(const std::vector<Edge>& edges, const RowLists& rows_on,
                               const std::vector<char>& is_body);
/// How many variables these have.
std::uint32_t variables_of(const std::vector<HubNode>& hubs);

/// Which rows meet: at a node, at the variables of a hub, which follow the rows, or as rows of a coupling.
RowLists neighbours_of(const std::vector<Edge>& edges, const RowLists& rows_on, const std::vector<HubNode>& hubs);

}  // namespace pantin
