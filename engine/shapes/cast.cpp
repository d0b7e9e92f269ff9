#include <algorithm>

#include "base/check.hpp"
#include "shapes/core.hpp"
#include "shapes/distance.hpp"
#include "shapes/hull.hpp"
#include "shapes/ray.hpp"
#include "shapes/way.hpp"

namespace pantin {

namespace {

using Hit = std::optional<RayHit>;

constexpr int most_cast_rounds = 200;

/// Of a convex shape above a half space.
Separation from_half_space(const Geometry& moved, const Pose& pose, const Pose& at_other) {
  const Core core = core_of(moved);
  const Vec3 n = at_other.R[2], low = pose.R * support(core, transposed_times(pose.R, -n)) - n * core.rounding;
  const double distance = dot(n, pose.x - at_other.x + low);
  return {distance, n, pose.x + low, pose.x + low - n * distance};
}

Separation gap_between(const Geometry& moved, const Pose& pose, const Geometry& other, const Pose& at_other,
                       SeparationCache& cache) {
  if (std::holds_alternative<HalfSpaceShape>(other)) return from_half_space(moved, pose, at_other);
  return separation(moved, pose, other, at_other, infinity, &cache);
}

/// Newton's method from the start: the distance of convex shapes that move straight is a convex function of the part, so
/// that no step goes past its first zero.
Hit cast_convex(const Geometry& moved, const Pose& pose, Vec3 way, const Geometry& other, const Pose& at_other) {
  const double half_space = std::holds_alternative<HalfSpaceShape>(other) ? 0.0 : thickness_of(other);
  const double touching = 1e-13 * (thickness_of(moved) + half_space);
  SeparationCache cache;
  double part = 0.0;
  Separation gap{};
  for (int round = 0; round < most_cast_rounds; round++) {
    gap = gap_between(moved, {pose.x + way * part, pose.R}, other, at_other, cache);
    if (gap.distance < -touching && round == 0) return RayHit{0.0, gap.normal};
    const double closing = -dot(gap.normal, way);
    if (!(closing > 0.0)) return {};
    if (gap.distance <= touching) break;
    const double next = part + gap.distance / closing;
    if (next > 1.0) return {};
    if (!(next > part)) break;
    part = next;
  }
  return RayHit{part, gap.normal};
}

/// A hull whose storage is kept from triangle to triangle.
class TriangleHull {
 public:
  TriangleHull() : hull_(std::make_shared<Hull>()), geometry_(std::shared_ptr<const Hull>(hull_)) {}
  const Geometry& of(const MeshTriangle& triangle) {
    set_triangle(*hull_, triangle.corner, triangle.normal);
    return geometry_;
  }

 private:
  std::shared_ptr<Hull> hull_;
  Geometry geometry_;
};

/// Calls f with the mesh or the height field that a shape is.
template <class F>
auto with_triangles(const Geometry& other, F f) {
  if (const auto* mesh = std::get_if<std::shared_ptr<const TriangleMesh>>(&other)) return f(**mesh);
  return f(*std::get<std::shared_ptr<const HeightField>>(other));
}

/// Whether it is below a height field's surface with its origin.
Hit below(const Geometry& other, const Pose& own) {
  if (const auto* field = std::get_if<std::shared_ptr<const HeightField>>(&other))
    if (const auto triangle = triangle_above(**field, own.x)) return RayHit{0.0, triangle->normal};
  return {};
}

/// Of what moves in axes of the triangles.
Hit cast_triangles(const Geometry& moved, const Pose& own, Vec3 along, const Geometry& other, bool fronts_alone) {
  if (const Hit hit = below(other, own)) return hit;
  const Bounds bounds = bounds_of(moved, own);
  const Way way{(bounds.low + bounds.high) * 0.5, along, (bounds.high - bounds.low) * 0.5};
  TriangleHull hull;
  const auto meet = [&](const MeshTriangle& triangle) {
    return fronts_alone && dot(along, triangle.normal) >= 0.0 ? Hit{}
                                                              : cast_convex(moved, own, along, hull.of(triangle), {});
  };
  return with_triangles(other, [&](const auto& triangles) { return first_met(triangles, way, meet); });
}

bool has_triangles(const Geometry& shape) {
  return !is_convex(shape) && !std::holds_alternative<HalfSpaceShape>(shape);
}

Pose relative(const Pose& pose, const Pose& to) {
  return {to.to_local(pose.x),
          {{transposed_times(to.R, pose.R[0]), transposed_times(to.R, pose.R[1]), transposed_times(to.R, pose.R[2])}}};
}

}  // namespace

std::optional<RayHit> cast(const Geometry& moved, const Pose& pose, Vec3 way, const Geometry& other,
                           const Pose& at_other, bool fronts_alone) {
  assume(is_convex(moved));
  if (!has_triangles(other)) return cast_convex(moved, pose, way, other, at_other);
  Hit hit = cast_triangles(moved, relative(pose, at_other), transposed_times(at_other.R, way), other, fronts_alone);
  if (hit) hit->normal = direction(at_other.R * hit->normal);
  return hit;
}

bool overlaps(const Geometry& convex, const Pose& pose, const Geometry& other, const Pose& at_other) {
  assume(is_convex(convex));
  SeparationCache cache;
  if (!has_triangles(other)) return gap_between(convex, pose, other, at_other, cache).distance <= 0.0;
  const Pose own = relative(pose, at_other);
  if (below(other, own)) return true;
  bool met = false;
  TriangleHull hull;
  const auto meet = [&](const MeshTriangle& triangle) {
    met = met || separation(convex, own, hull.of(triangle), {}, 0.0).distance <= 0.0;
  };
  with_triangles(other, [&](const auto& triangles) { triangles_in(triangles, bounds_of(convex, own), meet); });
  return met;
}

}  // namespace pantin
