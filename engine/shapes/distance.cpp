#include "shapes/distance.hpp"

#include "base/check.hpp"
#include "shapes/expand.hpp"
#include "shapes/gjk.hpp"
#include "shapes/near_point.hpp"
#include "shapes/polish.hpp"

namespace pantin {

namespace {

using Kind = Core::Kind;

bool has(const CorePair& pair, Kind kind) { return pair.a.kind == kind || pair.b.kind == kind; }

/// Some unit vector square to u.
Vec3 square_to(Vec3 u) {
  int thin = 0;
  for (int i = 1; i < 3; i++)
    if (std::fabs(u[i]) < std::fabs(u[thin])) thin = i;
  Vec3 axis = zero3();
  axis[thin] = 1.0;
  return direction(cross(u, axis));
}

double clamped(double x, double half) { return x < -half ? -half : x > half ? half : x; }

/// Lumelsky (1985), with the common normal where lines cross within both.
Separation of_segments(const CorePair& pair) {
  const Vec3 u = vec(0, 0, 1), v = pair.R[2], x = pair.x, n = cross(u, v);
  const double half_a = pair.a.half[2], half_b = pair.b.half[2], cosine = v[2], square = norm2(n);
  const double on_u = x[2], on_v = dot(v, x);
  double s = 0.0;
  if (square > 1e-30)
    s = clamped(dot(cross(x, v), n) / square, half_a);
  else
    s = clamped(on_u, half_a);
  double t = clamped(s * cosine - on_v, half_b);
  s = clamped(on_u + t * cosine, half_a);
  t = clamped(s * cosine - on_v, half_b);
  const Vec3 on_a = u * s, on_b = x + v * t, away = on_a - on_b;
  const bool within = std::fabs(s) < half_a && std::fabs(t) < half_b;
  const Vec3 aside = square > 1e-16 ? n / std::sqrt(square) : square_to(v);
  const double length = norm(away);
  if (length > 1e-8 * (half_a + half_b) && !(within && square > 1e-16)) return {length, away / length, on_a, on_b};
  if (!within && length > 1e-15 * (half_a + half_b)) return {length, away / length, on_a, on_b};
  const double along = dot(aside, x);
  return {std::fabs(along), along > 0.0 ? -aside : aside, on_a, on_b};
}

/// Of a point and a core that is no hull.
Separation of_point(const CorePair& pair) {
  if (pair.b.kind == Kind::point) {
    const NearPoint near = near_point(pair.a, pair.x);
    return {near.distance, -near.normal, near.at, pair.x};
  }
  const NearPoint near = near_point(pair.b, transposed_times(pair.R, -pair.x));
  return {near.distance, pair.R * near.normal, zero3(), pair.x + pair.R * near.at};
}

/// Whether a core has one point that is farthest along n, and that is sharp; sets it.
bool only_support(const Core& core, Vec3 n, Vec3& at) {
  if (core.kind == Kind::hull) return false;
  at = support(core, n);
  for (int i = 0; i < 3; i++)
    if (core.kind == Kind::box && !(std::fabs(n[i]) > 1e-6)) return false;
  if (core.kind == Kind::segment) return std::fabs(n[2]) > 1e-6;
  if (core.kind == Kind::cylinder) return std::fabs(n[2]) > 1e-6 && n[0] * n[0] + n[1] * n[1] > 1e-12;
  return true;
}

/// Nearest points for a normal that is known better than the simplex.
Separation along(const CorePair& pair, const Widest& widest, const Simplex& simplex, Vec3 moved) {
  const Vec3 n = widest.normal, way = n * widest.gap;
  Vec3 at;
  if (only_support(pair.a, -n, at)) return {widest.gap, n, at, at - way};
  if (only_support(pair.b, transposed_times(pair.R, n), at)) {
    const Vec3 on_b = pair.x + pair.R * at;
    return {widest.gap, n, on_b + way, on_b};
  }
  const Vec3 middle = (simplex.on_a() + simplex.on_b() + moved) * 0.5;
  return {widest.gap, n, middle + way * 0.5, middle - way * 0.5};
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
Separation overlapping(const CorePair& pair, Vec3 start) {
  Widest widest = widest_of(pair, start);
  const double size = size_of(pair.a) + size_of(pair.b);
  const auto drawn_apart = [&](Vec3 away) {
    CorePair apart = pair;
    apart.x -= away;
    return nearness(apart, widest.normal, infinity).simplex;
  };
  Vec3 away = widest.normal * (size - widest.gap);
  Simplex simplex = drawn_apart(away);
  if (has(pair, Kind::cylinder)) {
    widest = polished(pair, widest.normal, simplex);
    away = widest.normal * (size - widest.gap);
    simplex = drawn_apart(away);
  }
  return along(pair, widest, simplex, away);
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
  const Nearness near = nearness(pair, start, beyond);
  if (near.found == Nearness::Found::overlapping) return overlapping(pair, near.normal);
  const Simplex& simplex = near.simplex;
  if (near.found == Nearness::Found::apart && has(pair, Kind::cylinder))
    return along(pair, polished(pair, near.normal, simplex), simplex, zero3());
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
  Separation local = of_cores(pair, start, beyond + rounding);
  const Vec3 normal = direction(at_a.R * local.normal);
  if (cache != nullptr) cache->direction = normal;
  return {local.distance - rounding + 0.0, normal, at_a.to_world(local.on_a) - normal * pair.a.rounding,
          at_a.to_world(local.on_b) + normal * pair.b.rounding};
}

}  // namespace pantin
