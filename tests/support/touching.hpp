#pragma once
// Shapes that touch, and what their manifolds must be like.
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "contacts/manifold.hpp"
#include "shapes/hull.hpp"
#include "support/brute_shapes.hpp"

namespace pantin::touching {

struct Told final : ManifoldSink {
  std::vector<std::pair<Manifold, std::uint32_t>> manifolds;  ///< with their parts
  void take(const Manifold& manifold, std::uint32_t part) override { manifolds.emplace_back(manifold, part); }

  std::vector<ManifoldPoint> points() const {
    std::vector<ManifoldPoint> list;
    for (const auto& [manifold, part] : manifolds)
      list.insert(list.end(), manifold.points.begin(), manifold.points.begin() + manifold.count);
    return list;
  }
};

inline std::vector<ManifoldPoint> points_of(const Geometry& a, const Pose& at_a, const Geometry& b, const Pose& at_b,
                                            double margin) {
  Told told;
  SeparationCache cache;
  find_manifolds(a, at_a, b, at_b, margin, cache, told);
  return told.points();
}

inline double least_gap_of(const std::vector<ManifoldPoint>& points) {
  double least = infinity;
  for (const ManifoldPoint& p : points) least = std::fmin(least, p.gap);
  return least;
}

inline std::set<std::uint32_t> ids_of(const std::vector<ManifoldPoint>& points) {
  std::set<std::uint32_t> ids;
  for (const ManifoldPoint& p : points) ids.insert(p.id);
  return ids;
}

/// [m] how far a point is outside of a shape, 0 on its surface, below 0 inside; outside only a bound.
struct OutsideOf {
  Vec3 local;
  double operator()(const BallShape& ball) const { return norm(local) - ball.radius; }
  double operator()(const BoxShape& box) const {
    double out = -infinity;
    for (int i = 0; i < 3; i++) out = std::fmax(out, std::fabs(local[i]) - box.half[i]);
    return out;
  }
  double operator()(const CapsuleShape& capsule) const {
    const double z = std::fmin(std::fmax(local[2], -capsule.half), capsule.half);
    return norm(local - vec(0, 0, z)) - capsule.radius;
  }
  double operator()(const CylinderShape& cylinder) const {
    const double across = std::sqrt(local[0] * local[0] + local[1] * local[1]);
    return std::fmax(across - cylinder.radius, std::fabs(local[2]) - cylinder.half);
  }
  double operator()(const std::shared_ptr<const Hull>& hull) const {
    double out = -infinity;
    for (const Hull::Face& face : hull->faces) out = std::fmax(out, dot(face.normal, local) - face.offset);
    return out;
  }
  double operator()(const HalfSpaceShape&) const { return local[2]; }
  template <class Other>
  double operator()(const Other&) const {
    return 0.0;
  }
};

inline double outside_of(const Geometry& shape, const Pose& pose, Vec3 x) {
  return std::visit(OutsideOf{pose.to_local(x)}, shape);
}

inline Pose random_pose(Random& random, double extent) {
  return {brute::random_vector(random, extent), brute::random_turn(random)};
}

/// Moves and turns by about so much [m, rad].
inline Pose nudged(const Pose& pose, Random& random, double by) {
  const Vec3 turn = brute::random_vector(random, by);
  return {pose.x + brute::random_vector(random, by),
          matrix(normalised({1.0, 0.5 * turn[0], 0.5 * turn[1], 0.5 * turn[2]})) * pose.R};
}

}  // namespace pantin::touching
