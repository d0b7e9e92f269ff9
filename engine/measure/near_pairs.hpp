#pragma once
// Which of some positions are near to each other, in open space and in a box.
#include <cstdint>
#include <functional>
#include <span>

#include "laws/run/sites.hpp"

namespace pantin {

/// Calls `visit(a, b)` with the numbers of each two positions that are at most `distance` [m] >= 0 apart, a < b, in rising
/// order.
void each_near_pair(std::span<const Vec3> positions, const Box& box, double distance,
                    const std::function<void(std::uint32_t, std::uint32_t)>& visit);

}  // namespace pantin
