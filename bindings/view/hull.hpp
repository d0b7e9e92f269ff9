#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/lanes.hpp"

namespace pantin {

/// Triangles (indices into `points`, counter-clockwise from outside) of the convex hull, in O(n log n) on the average; empty
/// where the points lie in one plane, line or place.
std::vector<std::array<std::uint32_t, 3>> convex_hull(std::span<const Vec3> points);

}  // namespace pantin
