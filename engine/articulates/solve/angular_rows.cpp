// Angular rows: torques between two nodes, or on one from the world. With equal axes at both ends of the step the relative
// rotation a_a - a_b is along the mean axis, so that a torque across it does no work.
#include "articulates/solve/angular_rows.hpp"

#include "base/functions.hpp"
#include "constraints/row_rule.hpp"

namespace pantin {

namespace {

constexpr double pi = 3.14159265358979323846;

/// Rotation of the first node against where the second would have it, in the first's principal axes.
Quat violation(const Quat& a, const Quat& b, const Quat& turn) { return conjugate(b * turn) * a; }

/// Chord of the rotation, world axes: 2 sin(θ/2) along its axis, whose change is the small rotation itself.
Vec3 chord(const Quat& violation, const Mat3& R) {
  const double sign = violation.w < 0.0 ? -2.0 : 2.0;
  return R * vec(violation.x * sign, violation.y * sign, violation.z * sign);
}

/// Angle of the rotation about an axis (its twist), nearest to `near` [rad].
double twist(const Quat& violation, Vec3 axis, double near) {
  const double angle = 2.0 * functions::atan2(dot(vec(violation.x, violation.y, violation.z), axis), violation.w);
  return angle - 2.0 * pi * std::nearbyint((angle - near) / (2.0 * pi));
}

}  // namespace

void place_angular_row_at_start(Articulate& a, Row& row) {
  const Node& first = a.nodes[static_cast<std::size_t>(row.a)];
  const Node* second = row.b >= 0 ? &a.nodes[static_cast<std::size_t>(row.b)] : nullptr;
  const Condition& c = condition(a, row);
  row.ra0 = first.R0 * row.la;
  row.rb0 = second ? second->R0 * c.axis0 : c.axis0;
  if (row.kind == RowKind::rigid)
    row.d0 = chord(violation(first.q0, second ? second->q0 : Quat{}, c.turn0), first.R0) * row.lever;
}

void place_angular_row_at_end(Articulate& a, Row& row) {
  const Node& first = a.nodes[static_cast<std::size_t>(row.a)];
  const Node* second = row.b >= 0 ? &a.nodes[static_cast<std::size_t>(row.b)] : nullptr;
  Condition& c = condition(a, row);
  row.ra1 = first.R1 * row.la;
  row.rb1 = second ? second->R1 * c.axis1 : c.axis1;
  const Quat q = second ? second->q1 : Quat{};
  if (row.kind == RowKind::rigid) row.d1 = chord(violation(first.q1, q, c.turn1), first.R1) * row.lever;
  if (row.kind == RowKind::axis) row.d1 = cross(row.rb1, row.ra1) * row.lever;
  if (row.kind == RowKind::turn || row.kind == RowKind::coupled)
    c.angle1 = twist(violation(first.q1, q, c.turn1), row.la, c.angle0);
}

double work_of_angular_row(const Articulate& a, const Row& row) {
  const auto turned = [&](std::int32_t node) { return a.nodes[static_cast<std::size_t>(node)].a; };
  const Vec3 torque = row.f * row.lever;
  return dot(torque, turned(row.a)) - (row.b >= 0 ? dot(torque, turned(row.b)) : 0.0);
}

}  // namespace pantin
