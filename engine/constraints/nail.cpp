// A nail: a point stays at a position of the world, by a rigid row.
#include "base/check_values.hpp"
#include "constraints/geometry.hpp"
#include "constraints/plans.hpp"

namespace pantin {

namespace {

void start(const Model& model, Constraint& c, double tolerance) {
  start_point(model, c, from_position(model, c), velocity(model, c.a), tolerance);
}

double gap(const Model& model, const Constraint& c) { return norm(from_position(model, c) - c.attract.away); }

std::vector<RowPlan> rows(const Model&, const Constraint& c) { return {between_points(c, rigid_row)}; }

}  // namespace

const ConstraintRule nail_rule = {
    .joins_points = true,
    .ends_at_position = true,
    .check = [](const Model&, Constraint& c) { internal::require_finite("nail", "at", c.position.now, "m"); },
    .freedoms =
        [](const Constraint&) {
          return FreedomsTaken{3, 2};
        },
    .pins = [](const Constraint&) { return "nailed"; },
    .directions = all_directions,
    .start = start,
    .gap = gap,
    .rows = rows,
};

}  // namespace pantin
