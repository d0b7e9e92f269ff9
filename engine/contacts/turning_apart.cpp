#include "contacts/turning_apart.hpp"

#include <cmath>

#include "base/functions.hpp"
#include "contacts/features.hpp"
#include "contacts/manifold.hpp"

namespace pantin {

namespace {

/// The direction from where a cylinder's edge touches to its axis, and its sine.
struct Edge {
  Vec3 inward;
  double sine;
};
Edge edge_of(Vec3 axis, Vec3 out) {
  const Vec3 across = out - axis * dot(axis, out);
  const double sine = norm(across);
  return {sine > 0.0 ? across / sine : zero3(), sine};
}

Vec3 turned(Vec3 v, Vec3 by) {
  const double angle = norm(by);
  if (angle == 0.0) return v;
  const Vec3 n = by / angle;
  const double c = functions::cos(angle);
  return v * c + cross(n, v) * functions::sin(angle) + n * (dot(n, v) * (1.0 - c));
}

/// By how much turning takes what touches off its tangent, as a velocity over h: a cylinder's edge touches with another of its
/// points by then, so that only its axis turns with the body.
Vec3 off_tangent(const IslandBody& body, Vec3 r, Vec3 out, const Roundness& round, double h) {
  const Vec3 w = body.w0;
  const auto core = [&](Vec3 arm) { return cross(w, cross(w, arm)) * curving(w, h); };
  if (norm2(round.axis) == 0.0) return core(r + out * round.radius);
  const Edge now = edge_of(round.axis, out), then = edge_of(turned(round.axis, w * h), out);
  if (now.sine < lies_on_end || then.sine < lies_on_end) return core(r);
  const double along = dot(round.axis, out), rate = -along * dot(out, cross(w, round.axis)) / now.sine;
  const Vec3 slip = cross(w, then.inward - now.inward) * 0.5;
  return core(r + now.inward * round.radius) -
         (slip + out * ((then.sine - now.sine) / h - rate - dot(out, slip))) * round.radius;
}

/// The same of what is flat there, on which a round thing rolls or slides: the two touch where that is by then, and what the
/// flat one has there turns about. Along the normal the flat one turns under it, too.
Vec3 under_round(const IslandBody& flat, Vec3 arm, Vec3 out, Vec3 round_velocity, double h) {
  const Vec3 w = flat.w0, along = cross(w, round_velocity - flat.v0);
  const double normal = dot(out, along * 2.0 - cross(w, cross(w, arm)));
  return (along + out * (normal - dot(out, along))) * curving(w, h);
}

bool is_ball(const Roundness& round) { return round.radius > 0.0 && norm2(round.axis) == 0.0; }
bool is_flat(const Roundness& round, Vec3 out) {
  return norm2(round.axis) == 0.0 ? round.radius == 0.0 : edge_of(round.axis, out).sine < lies_on_end;
}

Vec3 core_velocity(const IslandBody& body, Vec3 arm, Vec3 out, const Roundness& round) {
  return body.v0 + cross(body.w0, arm + out * round.radius);
}

}  // namespace

double curving(Vec3 spin, double h) {
  const double half = 0.5 * norm(spin) * h, part = half > 1e-4 ? functions::sin(half) / half : 1.0 - half * half / 6.0;
  return 0.5 * h * part * part;
}

Vec3 turning_apart(const TouchIsland& island, const IslandContact& c, const Contact& from, double h) {
  const auto side = [&](std::int32_t number, Vec3 r, Vec3 out, const Roundness& round) {
    return off_tangent(island.problem.bodies[static_cast<std::size_t>(number)], r, out, round, h);
  };
  const Vec3 n = c.frame[0];
  Vec3 apart = zero3();
  if (is_point(from.body_a)) {  // its centre is where impulses act
    if (c.b >= 0) apart -= side(c.b, c.rb - n * (from.round_a.radius + from.gap), n * -1.0, from.round_b);
    return to_frame(c, apart);
  }
  const Vec3 half = n * (0.5 * from.gap);
  if (c.b < 0) return to_frame(c, side(c.a, c.ra, n, from.round_a));
  const Vec3 arm_a = c.ra + half, arm_b = c.rb - half;
  const IslandBody &a = island.problem.bodies[static_cast<std::size_t>(c.a)],
                   &b = island.problem.bodies[static_cast<std::size_t>(c.b)];
  const bool is_inner = from.key.feature == inner_ball_id;
  if (is_ball(from.round_b) && is_flat(from.round_a, n))
    apart += under_round(a, arm_a, n, core_velocity(b, arm_b, n * -1.0, from.round_b), h);
  else
    apart += side(c.a, arm_a, n, from.round_a);
  if (is_ball(from.round_a) && !is_inner && is_flat(from.round_b, n))
    apart -= under_round(b, arm_b, n, core_velocity(a, arm_a, n, from.round_a), h);
  else
    apart -= side(c.b, arm_b, n * -1.0, from.round_b);
  return to_frame(c, apart);
}

}  // namespace pantin
