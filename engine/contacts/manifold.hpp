#pragma once
// Where two shapes touch, or soon may: up to four points with a normal and gaps.
#include <array>

#include "shapes/distance.hpp"
#include "shapes/shape.hpp"

namespace pantin {

struct ManifoldPoint {
  Vec3 on_a;         ///< [m] world, on the surface of a; that of b is on_a - gap normal
  Vec3 normal;       ///< from b to a, of unit length
  double gap;        ///< [m] below 0: overlap
  std::uint32_t id;  ///< of the features that meet: the same in the next step where the same features do
};

struct Manifold {
  std::uint32_t count = 0;
  std::array<ManifoldPoint, 5> points;
};

/// Sets the points of two shapes with gaps up to `margin` [m], most important first where there are more than are kept. a is
/// convex; b may be any shape. With meshes and height fields there may be more than one manifold: `use` is called for each,
/// with a number that stays that of the same triangle.
struct ManifoldSink {
  virtual void take(const Manifold& manifold, std::uint32_t part) = 0;

 protected:
  ~ManifoldSink() = default;
};
void find_manifolds(const Geometry& a, const Pose& at_a, const Geometry& b, const Pose& at_b, double margin,
                    SeparationCache& cache, ManifoldSink& sink);

}  // namespace pantin
