// The angle between two axes, by torques across both: ū_b × ū_a of the means, which does work on cos θ exactly.
#include "base/check.hpp"
#include "base/functions.hpp"
#include "constraints/geometry.hpp"
#include "constraints/load.hpp"
#include "constraints/plans.hpp"
#include "constraints/row_rule.hpp"

namespace pantin {

namespace {

/// About which an axis turns away from another [unit]; of two along one line any.
Vec3 across(Vec3 from, Vec3 to) {
  constexpr double along = 1e-9;
  const Vec3 normal = cross(from, to);
  if (norm(normal) > along * norm(from) * norm(to)) return direction(normal);
  return direction(cross(from, std::fabs(from[0]) < 0.7 * norm(from) ? vec(1, 0, 0) : vec(0, 1, 0)));
}

double row_angle(const Row& row) { return functions::atan2(norm(cross(row.rb1, row.ra1)), dot(row.rb1, row.ra1)); }

double evaluate_align(Row& row, Condition& c, const RowContext& context) {
  const double value = row_angle(row) * row.lever - c.kept_value - c.accepted;
  return evaluate_function(
      row, c, {across(row.rb0 + row.rb1, row.ra0 + row.ra1), across(row.rb1, row.ra1), value, value}, context);
}

void project_align(const Row& row, Condition& c, bool holds) { project_function(c, across(row.rb1, row.ra1), holds); }

Vec3 align_gap(const Row& row, const Condition& c) {
  return across(row.rb1, row.ra1) * (row_angle(row) * row.lever - c.kept_value - c.accepted);
}

}  // namespace

const RowRule align_row = {.evaluate = evaluate_align, .project = project_align, .gap = align_gap};

namespace {

double value(const Model& model, const Constraint& c) {
  return angle_between(direction_of(model, c.body_a, c.axis_a), direction_of(model, c.body_b, c.axis_b));
}

double rate(const Model& model, const Constraint& c) {
  const Vec3 axis = direction_of(model, c.body_a, c.axis_a);
  return dot(direction(cross(direction_of(model, c.body_b, c.axis_b), axis)), relative_spin(model, c));
}

/// An angle that is 0 or π but for round-off leaves the axes no direction to turn in, and is kept in two.
void set(Constraint& c, std::string_view call, double angle) {
  constexpr double least = 1e-6, pi = 3.14159265358979323846;
  require(std::isfinite(angle) && angle >= 0.0 && angle <= pi, call, ": angle must be 0 to π rad, got ", angle);
  if (angle > pi - least) {
    c.axis_b *= -1.0;
    angle = 0.0;
  }
  c.number.now = angle < least ? 0.0 : angle;
}

/// An align to 0 turns its second axis, so that the two are one at once; this is in body_b's frame.
void start_together(const Model& model, Constraint& c, double tolerance) {
  const Quat frame = c.body_b ? orientation(model, c.body_b) : Quat{};
  const Vec3 axis = rotate(conjugate(frame), direction_of(model, c.body_a, c.axis_a));
  const double angle = angle_between(c.axis_b, axis);
  if (angle <= tolerance) return;
  c.attract.away = across(c.axis_b, axis) * angle;
  c.attract.away_rate =
      direction(c.attract.away) * dot(direction(c.attract.away), rotate(conjugate(frame), relative_spin(model, c)));
}

void start(const Model& model, Constraint& c, double tolerance) {
  if (c.number.now == 0.0) return start_together(model, c, tolerance);
  start_number(c, value(model, c) - c.number.now, rate(model, c), tolerance);
}

double gap(const Model& model, const Constraint& c) {
  if (c.number.now == 0.0 && norm2(c.attract.away) > 0.0) return 0.0;
  return lever(model, c) * std::fabs(value(model, c) - c.number.now - c.attract.excess);
}

std::vector<RowPlan> rows(const Model&, const Constraint& c) {
  return {angular_row(c, c.number.now == 0.0 ? axis_row : align_row)};
}

std::vector<PlaneNeed> in_plane(const Model& model, const Constraint& c) {
  return {{"the first axis", direction_of(model, c.body_a, c.axis_a), false},
          {"the second axis", direction_of(model, c.body_b, c.axis_b), false}};
}

}  // namespace

const ConstraintRule align_rule = {
    .keeps = kept_angle,
    .freedoms =
        [](const Constraint& c) {
          return c.number.now == 0.0 ? FreedomsTaken{2, 1} : FreedomsTaken{1, 1};
        },
    .directions = no_direction,
    .start = start,
    .gap = gap,
    .value = value,
    .set = set,
    .rows = rows,
    .load = load_axis,
    .in_plane = in_plane,
};

}  // namespace pantin
