// An orient: a body keeps an orientation, by a rigid angular row.
#include "base/rotation.hpp"
#include "constraints/geometry.hpp"
#include "constraints/plans.hpp"

namespace pantin {

namespace {

void start(const Model& model, Constraint& c, double tolerance) {
  const Vec3 away = present_turn(model, c);
  if (norm(away) <= tolerance) return;
  c.attract.away = away;
  c.attract.away_rate = angular_velocity(model.motion_of(c.body_a));
}

double gap(const Model& model, const Constraint& c) {
  return lever(model, c) * norm(present_turn(model, c) - c.attract.away);
}

std::vector<RowPlan> rows(const Model&, const Constraint& c) { return {angular_row(c, rigid_row)}; }

void load(Condition& condition, const Row& row, const Model& model, const Constraint& c) {
  condition.whole_turn0 = quaternion_of(model.plane.about(c.attract.previous_away)) * condition.whole_turn0;
  condition.whole_turn1 = quaternion_of(model.plane.about(c.attract.away)) * condition.whole_turn1;
  condition.velocity = model.plane.about(c.turn.rate + c.attract.away_rate) * row.lever;
}

}  // namespace

const ConstraintRule orient_rule = {
    .orients = true,
    .freedoms =
        [](const Constraint&) {
          return FreedomsTaken{3, 1};
        },
    .directions = no_direction,
    .start = start,
    .gap = gap,
    .rows = rows,
    .load = load,
};

}  // namespace pantin
