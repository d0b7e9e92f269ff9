#pragma once
#include "structures/structure.hpp"

namespace pantin {

/// The smallest rings of edges, of at most `longest`, whose vertices are within `thickness` [m] of a plane. They go
/// counter-clockwise seen from outside of the whole; where there is no outside, about the direction of rising x, y or z.
std::vector<StructureFace> flat_rings(const Structure& s, std::size_t longest, double thickness);

}  // namespace pantin
