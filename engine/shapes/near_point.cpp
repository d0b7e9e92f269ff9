#include "shapes/near_point.hpp"

#include "base/check.hpp"

namespace pantin {

namespace {

NearPoint of_point(Vec3 p) { return {norm(p), direction(p, vec(0, 0, 1)), zero3()}; }

NearPoint of_segment(double half, Vec3 p) {
  const Vec3 at = vec(0, 0, p[2] < -half ? -half : p[2] > half ? half : p[2]), away = p - at;
  return {norm(away), direction(away), at};
}

NearPoint of_box(Vec3 half, Vec3 p) {
  const Vec3 high = p > half ? half : p, at = high < -half ? -half : high, away = p - at;
  const double distance = norm(away);
  if (distance > 0.0) return {distance, away / distance, at};
  int face = 0;
  const auto depth = [&](int i) { return half[i] - std::fabs(p[i]); };
  for (int i = 1; i < 3; i++)
    if (depth(i) < depth(face)) face = i;
  NearPoint near{0.0 - depth(face), zero3(), p};
  near.normal[face] = p[face] < 0.0 ? -1.0 : 1.0;
  near.at[face] = p[face] < 0.0 ? -half[face] : half[face];
  return near;
}

NearPoint of_cylinder(double radius, double half, Vec3 p) {
  const double across = std::sqrt(p[0] * p[0] + p[1] * p[1]);
  const Vec3 out = across > 0.0 ? vec(p[0] / across, p[1] / across, 0) : vec(1, 0, 0);
  const Vec3 up = vec(0, 0, p[2] < 0.0 ? -1 : 1);
  const double side = across - radius, cap = std::fabs(p[2]) - half;
  if (side > 0.0 && cap > 0.0) {
    const double distance = std::sqrt(side * side + cap * cap);
    return {distance, out * (side / distance) + up * (cap / distance), out * radius + up * half};
  }
  if (side > cap) return {side, out, out * radius + vec(0, 0, p[2])};
  return {cap, up, vec(p[0], p[1], 0) + up * half};
}

}  // namespace

NearPoint near_point(const Core& core, Vec3 p) {
  switch (core.kind) {
    case Core::Kind::point: return of_point(p);
    case Core::Kind::segment: return of_segment(core.half[2], p);
    case Core::Kind::box: return of_box(core.half, p);
    case Core::Kind::cylinder: return of_cylinder(core.half[0], core.half[2], p);
    case Core::Kind::hull: assume(false);
  }
  return of_point(p);
}

}  // namespace pantin
