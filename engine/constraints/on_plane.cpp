// A point on a plane: n·(y - c) = 0 by a force along n. Linear, so that the force does no work.
#include "base/check_values.hpp"
#include "constraints/geometry.hpp"
#include "constraints/plans.hpp"
#include "constraints/row_rule.hpp"

namespace pantin {

namespace {

double evaluate_plane(Row& row, Condition& c, const RowContext& context) {
  const double height = dot(c.normal, row.d1) - c.accepted;
  return evaluate_function(row, c, {c.normal, c.normal, height, height, 0.0, norm(row.d1 - row.d0)}, context);
}

void project_plane(const Row&, Condition& c, bool holds) { project_function(c, c.normal, holds); }

Vec3 plane_gap(const Row& row, const Condition& c) { return c.normal * (dot(c.normal, row.d1) - c.accepted); }

}  // namespace

const RowRule plane_row = {.guides = true, .evaluate = evaluate_plane, .project = project_plane, .gap = plane_gap};

namespace {

void check(const Model&, Constraint& c) {
  internal::require_finite("on_plane", "through", c.position.now, "m");
  c.axis_a = internal::unit_vector("on_plane", "normal", c.axis_a);
}

void start(const Model& model, Constraint& c, double tolerance) {
  const Vec3 n = c.axis_a;
  start_point(model, c, n * dot(n, from_position(model, c)), n * dot(n, velocity(model, c.a)), tolerance);
}

double gap(const Model& model, const Constraint& c) {
  return std::fabs(dot(c.axis_a, from_position(model, c) - c.attract.away));
}

std::vector<RowPlan> rows(const Model&, const Constraint& c) { return {between_points(c, plane_row)}; }

}  // namespace

const ConstraintRule on_plane_rule = {
    .check = check,
    .freedoms =
        [](const Constraint&) {
          return FreedomsTaken{1, 1};
        },
    .directions =
        [](const Constraint& c) {
          return std::array<Vec3, 3>{c.axis_a, zero3(), zero3()};
        },
    .start = start,
    .gap = gap,
    .rows = rows,
    .in_plane =
        [](const Model&, const Constraint& c) {
          return std::vector<PlaneNeed>{{"normal", c.axis_a, false}};
        },
};

}  // namespace pantin
