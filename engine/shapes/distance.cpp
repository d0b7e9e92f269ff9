#include "shapes/distance.hpp"

#include "shapes/expand.hpp"
#include "shapes/gjk.hpp"
#include "shapes/near_point.hpp"
#include "shapes/nearest_points.hpp"
#include "shapes/polish.hpp"

namespace pantin {

namespace {

using Kind = Core::Kind;

bool has(const CorePair& pair, Kind kind) { return pair.a.kind == kind || pair.b.kind == kind; }

/// Of a point and a core that is no hull.
Separation of_point(const CorePair& pair) {
  if (pair.b.kind == Kind::point) {
    const NearPoint near = near_point(pair.a, pair.x);
    return {near.distance, -near.normal, near.at, pair.x};
  }
  const NearPoint near = near_point(pair.b, transposed_times(pair.R, -pair.x));
  return {near.distance, pair.R * near.normal, zero3(), pair.x + pair.R * near.at};
}

Widest widest_of(const CorePair& pair, Vec3 start) {
  if (pair.a.kind == Kind::box && pair.b.kind == Kind::box) return widest_of_boxes(pair);
  const bool round = has(pair, Kind::cylinder), line = has(pair, Kind::point) || has(pair, Kind::segment);
  if (line && !round) return widest_of_polyhedra(pair);
  const double size = size_of(pair.a) + size_of(pair.b);
  const Expanded expanded = expand(pair, start, (round ? 1e-10 : 1e-14) * size);
  return expanded.settled || round ? expanded.widest : widest_of_polyhedra(pair);
}

/// The cores are drawn apart along the normal: what is nearest then touches.
Separation overlapping(const CorePair& pair, Widest widest) {
  const double size = size_of(pair.a) + size_of(pair.b);
  CorePair apart = pair;
  const Vec3 away = widest.normal * (size - widest.gap);
  apart.x -= away;
  const Simplex simplex = nearness(apart, widest.normal, infinity).simplex;
  if (has(pair, Kind::cylinder)) widest = polished(pair, widest.normal, simplex);
  return nearest_points(pair, widest, simplex, away);
}

/// What is left of two points that nearly touch may be round-off: a direction that does not part the cores then.
void mend_normal(const CorePair& pair, Separation& separation) {
  const double gap = dot(separation.normal, pair.lowest(separation.normal).w);
  if (gap >= 0.999999 * separation.distance) return;
  const Widest widest = widest_of(pair, separation.normal);
  if (widest.gap > gap) separation.normal = widest.normal;
}

Separation of_cores(const CorePair& pair, Vec3 start, double beyond) {
  if (pair.a.kind == Kind::segment && pair.b.kind == Kind::segment) return of_segments(pair);
  if (has(pair, Kind::point) && !has(pair, Kind::hull)) return of_point(pair);
  if (pair.a.kind == Kind::box && pair.b.kind == Kind::box) {
    const Widest widest = widest_of_boxes(pair);
    if (!(widest.gap > 0.0)) return overlapping(pair, widest);
    start = widest.normal;
  }
  const Nearness near = nearness(pair, start, beyond);
  if (near.found == Nearness::Found::overlapping) return overlapping(pair, widest_of(pair, near.normal));
  const Simplex& simplex = near.simplex;
  if (near.found == Nearness::Found::apart && has(pair, Kind::cylinder))
    return nearest_points(pair, polished(pair, near.normal, simplex), simplex, zero3());
  Separation separation{near.distance, near.normal, simplex.on_a(), simplex.on_b()};
  if (near.distance < 1e-9 * (size_of(pair.a) + size_of(pair.b))) mend_normal(pair, separation);
  return separation;
}

}  // namespace

Separation separation(const Geometry& a, const Pose& at_a, const Geometry& b, const Pose& at_b, double beyond,
                      SeparationCache* cache) {
  const CorePair pair = core_pair(a, at_a, b, at_b);
  const double rounding = pair.a.rounding + pair.b.rounding;
  const bool known = cache != nullptr && norm2(cache->direction) > 0.0;
  const Vec3 start = known ? transposed_times(at_a.R, cache->direction) : direction(-pair.x);
  const Separation local = of_cores(pair, start, beyond + rounding);
  const Vec3 normal = direction(at_a.R * local.normal);
  if (cache != nullptr) cache->direction = normal;
  return {local.distance - rounding + 0.0, normal, at_a.to_world(local.on_a) - normal * pair.a.rounding,
          at_a.to_world(local.on_b) + normal * pair.b.rounding};
}

}  // namespace pantin
