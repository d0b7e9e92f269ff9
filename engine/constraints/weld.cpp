// A weld: two bodies keep their relative position and orientation, by a rigid row and an angular one.
#include "constraints/geometry.hpp"
#include "constraints/plans.hpp"

namespace pantin {

namespace {

double gap(const Model& model, const Constraint& c) {
  const auto at = [&](BodyId body, Vec3 arm) { return origin(model, body) + direction_of(model, body, arm); };
  return std::fmax(norm(at(c.body_a, c.as<WeldData>().arm_a) - at(c.body_b, c.as<WeldData>().arm_b)),
                   lever(model, c) * norm(present_turn(model, c)));
}

std::vector<RowPlan> rows(const Model&, const Constraint& c) {
  return {{&rigid_row, false, {}, {}, c.body_a, c.body_b, c.as<WeldData>().arm_a, c.as<WeldData>().arm_b, 0},
          angular_row(c, rigid_row)};
}

}  // namespace

const ConstraintRule weld_rule = {
    .joins_points = true,
    .freedoms =
        [](const Constraint&) {
          return FreedomsTaken{6, 3};
        },
    .directions = no_direction,
    .gap = gap,
    .rows = rows,
};

}  // namespace pantin
