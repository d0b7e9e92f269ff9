#pragma once
// Distances of convex shapes by trying everything, in extended precision, without any code of the room `shapes`.
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "base/random.hpp"
#include "shapes/shape.hpp"

namespace pantin::brute {

using Real = long double;
using Point = std::array<Real, 3>;

/// The hull of some points, widened by a radius.
struct Convex {
  std::vector<Point> points;                          ///< [m]
  std::vector<std::array<std::size_t, 3>> triangles;  ///< all whose plane has no point beyond it
  std::vector<std::array<std::size_t, 2>> edges;      ///< of those triangles, diagonals of faces too
  Real radius = 0.0L;                                 ///< [m]
};
/// Of the shape's own points, in its own axes.
Convex convex(std::span<const Vec3> points, double radius = 0.0);
Convex convex(const BoxShape& box);
/// Put somewhere, less an origin that both shapes of a pair share.
Convex put(const Convex& convex, const Pose& pose, Vec3 origin);

/// [m] below 0 as deep as they overlap.
double distance(const Convex& a, const Convex& b);
/// [m] the gap between their shadows along a direction of unit length, from b to a.
double gap_along(const Convex& a, const Convex& b, Vec3 normal);

/// A rotation, evenly distributed.
Mat3 random_turn(Random& random);
Vec3 random_vector(Random& random, double half);  ///< in a cube
Vec3 random_direction(Random& random);
/// Points on a ball.
std::vector<Vec3> random_points(Random& random, std::size_t count, double radius);

}  // namespace pantin::brute
