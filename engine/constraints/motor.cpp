// A motor: turns a body about an axis, by a row of the angle.
#include "base/check_values.hpp"
#include "constraints/geometry.hpp"
#include "constraints/plans.hpp"

namespace pantin {

namespace {

double value(const Model&, const Constraint& c) { return c.angle; }

void start(const Model& model, Constraint& c, double tolerance) {
  count_anew(model, c);
  if (c.by_speed) return;
  const Vec3 axis = direction_of(model, c.body_a, c.axis_a);
  start_number(c, c.angle - c.number.now, dot(axis, relative_spin(model, c)), tolerance);
}

std::vector<RowPlan> rows(const Model&, const Constraint& c) { return {angular_row(c, turn_row)}; }

void load(Condition& condition, const Row&, const Model&, const Constraint&) { condition.works_along_d = true; }

std::vector<PlaneNeed> in_plane(const Model& model, const Constraint& c) {
  return {{"axis", direction_of(model, c.body_a, c.axis_a), true}};
}

}  // namespace

const ConstraintRule motor_rule = {
    .keeps = kept_angle,
    .check = [](const Model&,
                Constraint& c) { internal::require_positive_or_infinite("motor", "max_torque", c.max_torque, "N m"); },
    .freedoms =
        [](const Constraint& c) {
          return std::isfinite(c.max_torque) ? FreedomsTaken{} : FreedomsTaken{1, 1};
        },
    .directions = no_direction,
    .start = start,
    .value = value,
    .rows = rows,
    .load = load,
    .in_plane = in_plane,
};

}  // namespace pantin
