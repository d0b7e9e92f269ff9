#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "structures/structure.hpp"

namespace pantin {

/// Cells in x, y and z of a lattice; z of a flat one does not count.
struct LatticeCells {
  int x = 1, y = 1, z = 1;
};

/// "cubic", "fcc", "bcc", "diamond" in space; "square", "triangular", "honeycomb", "kagome" in the plane z = 0.
std::vector<std::string> lattice_kinds();
/// All positions of a block of right-angled cells, its bounds included, centred on the origin; neighbours are tied by edges
/// of length `edge` [m] > 0. What has fewer than two neighbours (in bcc: none) is left out. Flat ones have faces.
Structure lattice(std::string_view kind, const LatticeCells& cells, double edge);

}  // namespace pantin
