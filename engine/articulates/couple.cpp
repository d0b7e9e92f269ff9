// Couples: torques between two nodes, or on one from the world. With equal axes at both ends of the step the relative
// rotation ā_a - ā_b is along the mean axis, so that a torque across it does no work.
#include "articulates/couple.hpp"

#include "articulates/rows.hpp"
#include "base/functions.hpp"

namespace pantin {

namespace {

constexpr double pi = 3.14159265358979323846;

/// Rotation of the first node against where the second would have it, in the first's principal axes.
Quat deviation(const Quat& a, const Quat& b, const Quat& turn) { return conjugate(b * turn) * a; }

/// Chord of the rotation, world axes: 2 sin(θ/2) along its axis, whose change is the small rotation itself.
Vec3 chord(const Quat& deviation, const Mat3& R) {
  const double sign = deviation.w < 0.0 ? -2.0 : 2.0;
  return R * vec(deviation.x * sign, deviation.y * sign, deviation.z * sign);
}

/// Angle of the rotation about an axis (its twist), nearest to `near` [rad].
double twist(const Quat& deviation, Vec3 axis, double near) {
  const double angle = 2.0 * functions::atan2(dot(vec(deviation.x, deviation.y, deviation.z), axis), deviation.w);
  return angle - 2.0 * pi * std::nearbyint((angle - near) / (2.0 * pi));
}

Vec3 mean_axis(const Row& row) { return direction(row.ra0 + row.rb0 + row.ra1 + row.rb1); }
/// Of the angle about it, by the small rotation.
Vec3 twist_gradient(const Row& row) { return (row.ra1 + row.rb1) / std::fmax(1.0 + dot(row.ra1, row.rb1), 1e-3); }

}  // namespace

void place_couple_at_start(Articulate& a, Row& row) {
  const Node& first = a.nodes[static_cast<std::size_t>(row.a)];
  const Node* second = row.b >= 0 ? &a.nodes[static_cast<std::size_t>(row.b)] : nullptr;
  const Condition& c = condition(a, row);
  row.ra0 = first.R0 * row.la;
  row.rb0 = second ? second->R0 * c.axis0 : c.axis0;
  if (row.kind == RowKind::rigid)
    row.d0 = chord(deviation(first.q0, second ? second->q0 : Quat{}, c.turn0), first.R0) * row.lever;
}

void place_couple_at_end(Articulate& a, Row& row) {
  const Node& first = a.nodes[static_cast<std::size_t>(row.a)];
  const Node* second = row.b >= 0 ? &a.nodes[static_cast<std::size_t>(row.b)] : nullptr;
  Condition& c = condition(a, row);
  row.ra1 = first.R1 * row.la;
  row.rb1 = second ? second->R1 * c.axis1 : c.axis1;
  const Quat q = second ? second->q1 : Quat{};
  if (row.kind == RowKind::rigid) row.d1 = chord(deviation(first.q1, q, c.turn1), first.R1) * row.lever;
  if (row.kind == RowKind::axis) row.d1 = cross(row.rb1, row.ra1) * row.lever;
  if (row.kind == RowKind::turn) c.angle1 = twist(deviation(first.q1, q, c.turn1), row.la, c.angle0);
}

double work_of_couple(const Articulate& a, const Row& row) {
  const auto turned = [&](std::int32_t node) { return a.nodes[static_cast<std::size_t>(node)].a; };
  const Vec3 torque = row.f * row.lever;
  return dot(torque, turned(row.a)) - (row.b >= 0 ? dot(torque, turned(row.b)) : 0.0);
}

// Two axes stay together: d = lever n_b × n_a, and the force along their mean is 0.
double evaluate_axis(Row& row, Condition& c, const RowContext& context) {
  const double kappa = 0.5 * context.h * context.h * context.mobility;
  const Vec3 n = mean_axis(row), open = row.d1 - row.offset;
  const double along = dot(row.f, n);
  row.residual = open + n * (along * kappa);
  c.M = identity33() - outer(row.rb1, row.rb1);
  c.C = outer(n, n) * kappa;
  return std::fmax(norm(open), std::fabs(along) * kappa);
}

void project_axis(const Row& row, Condition& c) {
  const Vec3 n = direction(row.ra1 + row.rb1);
  c.kept = identity33() - outer(n, n);
}

Vec3 axis_gap(const Row& row, const Condition&) { return row.d1 - row.offset; }

// The angle between two axes, by torques across both: ū_b × ū_a of the means, which does work on cos θ exactly.
namespace {
double angle_between(const Row& row) { return functions::atan2(norm(cross(row.rb1, row.ra1)), dot(row.rb1, row.ra1)); }
}  // namespace

double evaluate_align(Row& row, Condition& c, const RowContext& context) {
  const double value = angle_between(row) * row.lever - c.length - c.accepted;
  return evaluate_reading(
      row, c,
      {direction(cross(row.rb0 + row.rb1, row.ra0 + row.ra1)), direction(cross(row.rb1, row.ra1)), value, value},
      context);
}

void project_align(const Row& row, Condition& c) { project_reading(c, cross(row.rb1, row.ra1)); }

Vec3 align_gap(const Row& row, const Condition& c) {
  return direction(cross(row.rb1, row.ra1)) * (angle_between(row) * row.lever - c.length - c.accepted);
}

namespace {

/// A motor that stalls: its force grows with what it misses.
double evaluate_yielding(Row& row, Condition& c, const Reading& r, const RowContext& context) {
  const double kappa = 0.5 * context.h * context.h * context.mobility, weight = kappa / (1.0 + kappa / c.yielding);
  const double wanted = -r.low / c.yielding, given = std::fmin(c.upper, std::fmax(c.lower, wanted));
  c.held = false;
  row.residual = (row.f - r.n * given) * weight;
  c.M = given == wanted ? outer(r.n, r.gradient) * (weight / c.yielding) : zero33();
  c.C = identity33() * weight;
  return norm(row.residual);
}

}  // namespace

// The angle about an axis: driven to a value (motor), or kept in a range (limit).
double evaluate_turn(Row& row, Condition& c, const RowContext& context) {
  const double value = c.angle1 * row.lever - c.accepted;
  const double low = c.ranged ? low_end(c) : c.length, high = c.ranged ? high_end(c) : c.length;
  const Reading reading{mean_axis(row), twist_gradient(row), value - low, value - high};
  if (std::isfinite(c.stalled)) return evaluate_yielding(row, c, reading, context);
  return evaluate_reading(row, c, reading, context);
}

void project_turn(const Row& row, Condition& c) {
  const Vec3 gradient = twist_gradient(row);
  project_reading(c, gradient,
                  std::fmax(1.0, norm(gradient)));  // less only where the axes are opposite, and it has none
}

Stop stop_of_turn(const Row& row, const Condition& c) {
  const double value = c.angle1 * row.lever - c.accepted;
  return nearer_end(direction(twist_gradient(row)), value - low_end(c), value - high_end(c));
}

Vec3 turn_gap(const Row& row, const Condition& c) {
  const double value = c.angle1 * row.lever - c.accepted;
  return direction(twist_gradient(row)) *
         missing(c, value - (c.ranged ? low_end(c) : c.length), value - (c.ranged ? high_end(c) : c.length));
}

}  // namespace pantin
