#pragma once
// Points that a pair may have, before those that matter are chosen.
#include <span>

#include "contacts/manifold.hpp"

namespace pantin {

/// Points of one pair in any number that clipping gives; what does not fit is left out.
struct PointList {
  static constexpr std::uint32_t capacity = 160;
  std::uint32_t count = 0;
  std::array<ManifoldPoint, capacity> points;

  void add(const ManifoldPoint& point) {
    if (count < capacity) points[count++] = point;
  }
  operator std::span<const ManifoldPoint>() const { return std::span(points).first(count); }
};

/// Part of the reach within which gaps are held for equal.
inline constexpr double same_gap = 1e-9;
/// Parts of the reach: how much higher than the lowest a point may be that counts in full, and that counts by half.
inline constexpr double as_low = 1e-5, half_as_low = 1e-3;

/// [m]
double least_gap(std::span<const ManifoldPoint> points);

/// Adds up to four points to a manifold: the deepest, the one farthest from it, and those farthest from the line
/// between the two on either side; what is open by more than `turn_way` [m] and a little counts less. Of points that are
/// equally good within round-off of `reach` [m] that of the smallest id. No two have the same id.
void keep_points(std::span<const ManifoldPoint> points, double reach, double turn_way, Manifold& manifold);

}  // namespace pantin
