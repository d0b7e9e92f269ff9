#include "shapes/gjk.hpp"

namespace pantin {

namespace {

constexpr int most_rounds = 200;

bool smooth(const Core& core) { return core.kind == Core::Kind::cylinder; }

}  // namespace

double size_of(const Core& core) {
  if (core.kind == Core::Kind::hull) return core.hull->reach;
  if (core.kind != Core::Kind::cylinder) return norm(core.half);
  return std::sqrt(core.half[0] * core.half[0] + core.half[2] * core.half[2]);
}

Nearness nearness(const CorePair& pair, Vec3 start, double beyond) {
  using Found = Nearness::Found;
  const double size = size_of(pair.a) + size_of(pair.b);
  const double accepted = smooth(pair.a) || smooth(pair.b) ? 1e-10 : 1e-15;
  Nearness now;
  Simplex& simplex = now.simplex;
  now.found = Found::apart;
  now.normal = direction(start);
  Difference next = pair.lowest(now.normal);
  now.distance = dot(now.normal, next.w);
  if (now.distance > beyond) return now.found = Found::beyond, now;
  simplex.corner[0] = next;
  simplex.count = 1;
  reduce(simplex);
  for (int round = 0; round < most_rounds; round++) {
    const double length = norm(simplex.nearest);
    if (length <= 1e-14 * size) return now.found = Found::overlapping, now;
    now.normal = simplex.nearest / length;
    now.distance = length;
    next = pair.lowest(now.normal);
    const double bound = dot(now.normal, next.w);
    if (bound > beyond) return now.distance = bound, now.found = Found::beyond, now;
    if (length - bound <= accepted * size + 1e-15 * length || simplex.has(next.w)) return now;
    const Simplex before = simplex;
    simplex.corner[static_cast<std::size_t>(simplex.count++)] = next;
    if (!reduce(simplex)) return now.found = Found::overlapping, now;
    if (!(norm2(simplex.nearest) < length * length)) return simplex = before, now;
  }
  return now;
}

}  // namespace pantin
