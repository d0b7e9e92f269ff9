#pragma once
#include "shapes/shape.hpp"

namespace pantin {

/// Of two convex shapes: the distance between their surfaces, below 0 as deep as they overlap (the smallest displacement
/// that parts them), and the nearest points.
struct Separation {
  double distance;  ///< [m]
  Vec3 normal;      ///< from b to a, of unit length
  Vec3 on_a, on_b;  ///< [m] world; on_a - on_b = distance normal
};

/// Where the last search for a pair of shapes ended: the next one begins there. Changes no result but by round-off.
struct SeparationCache {
  Vec3 direction = zero3();  ///< world; 0: nothing known
};

/// Gilbert, Johnson and Keerthi (1988) on the cores, expanding polytope (van den Bergen 2001) where those overlap. Past
/// `beyond` [m] the distance is only known to be more.
Separation separation(const Geometry& a, const Pose& at_a, const Geometry& b, const Pose& at_b,
                      double beyond = infinity, SeparationCache* cache = nullptr);

}  // namespace pantin
