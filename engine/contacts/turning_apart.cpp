#include "contacts/turning_apart.hpp"

#include <algorithm>
#include <cmath>

namespace pantin {

namespace {

/// By how much turning alone moves a surface away along `out` [m/s²], the normal that points into its shape, at the arm r to
/// it: n·(ω × (ω × r)) of what turns with the body there, less what a round surface has behind it.
double opening_of_side(const IslandBody& body, Vec3 r, Vec3 out, const Roundness& round) {
  const Vec3 w = body.w0, turning = norm2(round.axis) > 0.0 ? r : r + out * round.radius;
  const double edge = dot(out, w) * dot(w, turning) - norm2(w) * dot(out, turning);
  if (edge <= 0.0 || norm2(round.axis) == 0.0) return edge;
  const Vec3 across = out - round.axis * dot(round.axis, out);
  const double size = norm(across), turn = dot(cross(round.axis, across), cross(w, out));
  return size > 0.0 ? std::max(0.0, edge - round.radius * turn * turn / (size * size * size)) : edge;
}

/// From the surface to what turns with the body, where that rolls: not on the flat end of a cylinder.
Vec3 to_core(Vec3 out, const Roundness& round) {
  constexpr double flat = 0.1;  // sine of the angle between the axis and the normal
  const Vec3 across = out - round.axis * dot(round.axis, out);
  const double size = norm(across);
  return size > flat ? across * (round.radius / size) : zero3();
}

}  // namespace

double curving(Vec3 spin, double h) {
  const double half = 0.5 * norm(spin) * h, part = half > 1e-4 ? std::sin(half) / half : 1.0 - half * half / 6.0;
  return 0.5 * h * part * part;
}

Vec3 turning_apart(const TouchIsland& island, const IslandContact& c, const Contact& from, double h) {
  const auto side = [&](std::int32_t number, Vec3 r, Vec3 out, const Roundness& round) {
    const IslandBody& body = island.problem.bodies[static_cast<std::size_t>(number)];
    Vec3 way = cross(body.w0, cross(body.w0, r + to_core(out, round)));
    way -= out * dot(out, way);
    return (way + out * opening_of_side(body, r, out, round)) * curving(body.w0, h);
  };
  const Vec3 n = c.frame[0];
  Vec3 apart = zero3();
  if (is_point(from.body_a)) {  // its centre is where impulses act
    if (c.b >= 0) apart -= side(c.b, c.rb - n * (from.round_a.radius + from.gap), n * -1.0, from.round_b);
    return to_frame(c, apart);
  }
  const Vec3 half = n * (0.5 * from.gap);
  apart += c.b < 0 ? side(c.a, c.ra, n, from.round_a) : side(c.a, c.ra + half, n, from.round_a);
  if (c.b >= 0) apart -= side(c.b, c.rb - half, n * -1.0, from.round_b);
  return to_frame(c, apart);
}

}  // namespace pantin
