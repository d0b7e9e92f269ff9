#include "constraints/geometry.hpp"

#include <cmath>

#include "base/check.hpp"
#include "base/check_values.hpp"
#include "base/functions.hpp"
#include "constraints/kind.hpp"

namespace pantin {

namespace {

/// Where body_b, or the world, wants body_a's frame.
Quat wanted_orientation(const Model& model, const Constraint& c) {
  return c.body_b ? orientation(model, c.body_b) * c.turn.now : c.turn.now;
}

/// Mean radius of gyration about its axes [m].
double mean_gyration(const Motion& m) {
  return std::sqrt((m.inertia[0] + m.inertia[1] + m.inertia[2]) / (2.0 * m.mass));
}

}  // namespace

double end_distance_rate(const Model& model, const Constraint& c) {
  const Vec3 d = position(model, c.a) - (c.b ? position(model, c.b) : c.position.now);
  const Vec3 v = velocity(model, c.a) - (c.b ? velocity(model, c.b) : zero3());
  return dot(direction(d), v);
}

Vec3 present_turn(const Model& model, const Constraint& c) {
  const Quat q = orientation(model, c.body_a) * conjugate(wanted_orientation(model, c));
  const double sign = q.w < 0.0 ? -1.0 : 1.0, s = norm(vec(q.x, q.y, q.z));
  return direction(vec(q.x, q.y, q.z)) * (2.0 * sign * functions::atan2(s, std::fabs(q.w)));
}

double lever(const Model& model, BodyId a, BodyId b) {
  const double of_a = mean_gyration(model.motion_of(a));
  return b ? std::fmin(of_a, mean_gyration(model.motion_of(b))) : of_a;
}

void require_two_ends(const Model& model, const Constraint& c, std::string_view hint) {
  const std::string_view call = kind_name(c.kind);
  if (!c.b) return internal::require_finite(call, "position", c.position.now, "m");
  const Point &first = model.points[c.a], &second = model.points[c.b];
  require(first.particle != second.particle, call, ": its ends are one particle, ", describe(model, first.particle),
          hint);
  require(!first.body || first.body != second.body, call, ": both ends belong to ", describe(model, first.body),
          ", which is rigid already");
}

double present_angle(const Model& model, BodyId body_a, BodyId body_b, const Quat& turn, Vec3 axis_b, double last) {
  constexpr double whole = 6.283185307179586;
  const Quat frame = body_b ? orientation(model, body_b) : Quat{};
  const Quat q = conjugate(frame) * orientation(model, body_a) * conjugate(turn);
  const double angle = 2.0 * functions::atan2(dot(vec(q.x, q.y, q.z), axis_b), q.w);
  return angle + whole * std::round((last - angle) / whole);
}

void count_anew(const Model& model, Constraint& c) {
  constexpr double same = 1e-9;  // [rad]
  const double now = present_angle(model, c.body_a, c.body_b, c.turn.now, c.axis_b, c.angle);
  if (std::fabs(now - c.angle) > same) c.angle = now;
}

void start_number(Constraint& c, double excess, double rate, double allowed) {
  if (std::fabs(excess) <= allowed) return;
  c.attract.excess = c.attract.first_excess = excess;
  c.attract.excess_rate = rate;
}

void start_point(const Model& model, Constraint& c, Vec3 away, Vec3 rate, double tolerance) {
  const double size = size_of(model, c.a);
  if (norm(away) <= tolerance * (size > 0.0 || pins(c) ? size : largest(c.position.now))) return;
  c.attract.away = away;
  c.attract.away_rate = rate;
}

}  // namespace pantin
