#pragma once
// Which of some places are near to each other, in open space and in a box.
#include <cstdint>
#include <functional>
#include <span>

#include "laws/run/sites.hpp"

namespace pantin {

/// Calls `visit(a, b)` with the numbers of each two places that are at most `distance` [m] >= 0 apart, a < b, in rising
/// order.
void each_near_pair(std::span<const Vec3> places, const Box& box, double distance,
                    const std::function<void(std::uint32_t, std::uint32_t)>& visit);

}  // namespace pantin
