#pragma once
#include <cstdint>
#include <limits>
#include <vector>

#include "articulates/factor.hpp"

namespace pantin {

/// An order of elimination.
struct Elimination {
  std::vector<std::uint32_t> order;  // (rows) the row eliminated at each position
  RowLists columns;                  // (positions) positions of the blocks below the diagonal, rising
};
/// Greedy minimum-degree order of a graph, first in first out among equals, so that a chain is eliminated from both ends.
/// `neighbours` (rows): rising, without the row itself. The `late` last rows come after all others, as they are. Empty where the
/// squares of the columns' blocks would add up to more than `most`.
Elimination minimum_degree(const RowLists& neighbours, std::uint32_t late = 0,
                           std::size_t most = std::numeric_limits<std::size_t>::max());
/// Lays out a factor for an elimination.
Factor lay_out(RowLists columns);

}  // namespace pantin
