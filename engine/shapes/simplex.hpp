#pragma once
#include <array>

#include "shapes/core.hpp"

namespace pantin {

/// Up to four differences of points, and the point of their hull that is nearest to the origin.
struct Simplex {
  std::array<Difference, 4> corner;
  std::array<double, 4> part;  ///< of each corner in the nearest point; their sum is 1
  int count = 0;
  Vec3 nearest = zero3();  ///< [m]

  bool has(Vec3 w) const {
    for (int i = 0; i < count; i++)
      if (same(corner[static_cast<std::size_t>(i)].w, w)) return true;
    return false;
  }
  Vec3 on_a() const;  ///< [m] of the nearest point
  Vec3 on_b() const;
};

/// Finds the nearest point and drops the corners it does not need. False where the origin is inside four of them.
bool reduce(Simplex& simplex);

}  // namespace pantin
