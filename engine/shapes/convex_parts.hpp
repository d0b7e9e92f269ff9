#pragma once
#include <span>
#include <vector>

#include "base/lanes.hpp"

namespace pantin {

/// Divides the area within an outline [m], corners in a plane across `normal` in either sense, into convex ones that share
/// edges, each with corners of the outline, anticlockwise about the normal: ears are cut off (Meisters 1975), and put together
/// again where that stays convex (Hertel and Mehlhorn 1983). Corners on a straight line are left out. Throws Error where the
/// outline crosses itself or has no area.
std::vector<std::vector<Vec3>> convex_parts(std::span<const Vec3> outline, Vec3 normal);

}  // namespace pantin
