#include "shapes/nearest_points.hpp"

#include <algorithm>

#include "shapes/gjk.hpp"

namespace pantin {

namespace {

using Kind = Core::Kind;

/// Sine of an angle that is round-off.
constexpr double parallel = 1e-10;

/// What of a core is farthest along a direction.
struct Feature {
  enum class Form : unsigned char { point, segment, plane } form;
  Vec3 middle;  ///< [m] a point of it
  Vec3 half;    ///< [m] of a segment, from its middle to an end
};

Feature feature_of_hull(const Hull& hull, Vec3 n) {
  const Vec3 first = hull.vertices[farthest(hull, n)];
  const double least = dot(n, first) - parallel * hull.reach;
  Vec3 second = first;
  int others = 0;
  for (const Vec3 v : hull.vertices)
    if (dot(n, v) >= least && !same(v, first)) second = v, others++;
  if (others > 1) return {Feature::Form::plane, first, zero3()};
  return {others == 1 ? Feature::Form::segment : Feature::Form::point, (first + second) * 0.5, (second - first) * 0.5};
}

Feature feature_of_box(Vec3 half, Vec3 n) {
  Feature feature{Feature::Form::point, zero3(), zero3()};
  int along = 0;
  for (int i = 0; i < 3; i++) {
    if (std::fabs(n[i]) > parallel)
      feature.middle[i] = n[i] < 0.0 ? -half[i] : half[i];
    else
      feature.half[i] = half[i], along++;
  }
  if (along > 0) feature.form = along == 1 ? Feature::Form::segment : Feature::Form::plane;
  return feature;
}

/// In axes of its own.
Feature feature_of(const Core& core, Vec3 n) {
  if (core.kind == Kind::hull) return feature_of_hull(*core.hull, n);
  if (core.kind == Kind::box) return feature_of_box(core.half, n);
  const Vec3 end = support(core, n), axis = vec(0, 0, core.half[2]);
  if (core.kind == Kind::point) return {Feature::Form::point, zero3(), zero3()};
  if (std::fabs(n[2]) <= parallel) return {Feature::Form::segment, vec(end[0], end[1], 0), axis};
  const bool cap = core.kind == Kind::cylinder && n[0] * n[0] + n[1] * n[1] <= parallel * parallel;
  return {cap ? Feature::Form::plane : Feature::Form::point, end, zero3()};
}

bool has_rim(const Core& core) { return core.kind == Kind::cylinder; }

double clamped(double x, double half) { return std::clamp(x, -half, half); }

/// Nearest points of two segments by their middles and halves: parts of the halves, -1 … 1 (Lumelsky 1985).
std::array<double, 2> parts_of(Vec3 x, Vec3 u, Vec3 v) {
  const Vec3 n = cross(u, v);
  const double uu = norm2(u), vv = norm2(v), uv = dot(u, v), on_u = dot(u, x), on_v = dot(v, x), square = norm2(n);
  double s = 0.0;
  if (square > parallel * parallel * uu * vv) {
    s = clamped(dot(cross(x, v), n) / square, 1.0);
  } else {
    const double reach = std::fabs(uv) / uu, at = on_u / uu;
    const double low = std::max(-1.0, at - reach), high = std::min(1.0, at + reach);
    s = low <= high ? 0.5 * (low + high) : clamped(at, 1.0);
  }
  double t = clamped((s * uv - on_v) / vv, 1.0);
  s = clamped((on_u + t * uv) / uu, 1.0);
  t = clamped((s * uv - on_v) / vv, 1.0);
  return {s, t};
}

/// Some unit vector square to u.
Vec3 square_to(Vec3 u) {
  int thin = 0;
  for (int i = 1; i < 3; i++)
    if (std::fabs(u[i]) < std::fabs(u[thin])) thin = i;
  Vec3 axis = zero3();
  axis[thin] = 1.0;
  return direction(cross(u, axis));
}

}  // namespace

Separation of_segments(const CorePair& pair) {
  const Vec3 u = pair.a.half, v = pair.R[2] * pair.b.half[2], n = cross(u, v);
  const auto [s, t] = parts_of(pair.x, u, v);
  const Vec3 on_a = u * s, on_b = pair.x + v * t, away = on_a - on_b;
  const double length = norm(away), size = norm(u) + norm(v);
  const bool lines = norm2(n) > 1e-16 * norm2(u) * norm2(v);
  const bool within = lines && std::fabs(s) < 1.0 && std::fabs(t) < 1.0;
  if (!within && length > 1e-15 * size) return {length, away / length, on_a, on_b};
  const Vec3 aside = lines ? direction(n) : square_to(v);
  const double along = -dot(aside, pair.x);
  return {std::fabs(along), along < 0.0 ? -aside : aside, on_a, on_b};
}

Separation nearest_points(const CorePair& pair, const Widest& widest, const Simplex& simplex, Vec3 moved) {
  using Form = Feature::Form;
  const Vec3 n = widest.normal, way = n * widest.gap;
  const Feature a = feature_of(pair.a, -n), own_b = feature_of(pair.b, transposed_times(pair.R, n));
  const Feature b{own_b.form, pair.x + pair.R * own_b.middle, pair.R * own_b.half};
  const Vec3 guess = (simplex.on_a() + simplex.on_b() + moved) * 0.5;
  if (a.form == Form::point || b.form == Form::point) {
    const Vec3 on_a = a.form == Form::point ? a.middle : b.middle + way;
    // A rim that is as good as parallel to what it is on may be lowest elsewhere than where it is met.
    const double aside = norm(on_a - guess - way * 0.5), size = size_of(pair.a) + size_of(pair.b);
    if (aside <= 1e-3 * size || !(has_rim(pair.a) || has_rim(pair.b))) return {widest.gap, n, on_a, on_a - way};
    return {widest.gap, n, guess + way * 0.5, guess - way * 0.5};
  }
  if (a.form == Form::segment && b.form == Form::segment) {
    const Vec3 on_a = a.middle + a.half * parts_of(b.middle - a.middle, a.half, b.half)[0];
    return {widest.gap, n, on_a, on_a - way};
  }
  const auto onto = [&](const Feature& feature, Vec3 p) {
    if (feature.form == Form::plane) return p + n * dot(n, feature.middle - p);
    return feature.middle + feature.half * clamped(dot(feature.half, p - feature.middle) / norm2(feature.half), 1.0);
  };
  if (a.form == Form::segment || b.form == Form::plane) {
    const Vec3 on_a = onto(a, guess);
    return {widest.gap, n, on_a, on_a - way};
  }
  const Vec3 on_b = onto(b, guess);
  return {widest.gap, n, on_b + way, on_b};
}

}  // namespace pantin
