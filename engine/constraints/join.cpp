// A join: two points are `position1` apart at the end of the step, which goes to 0 as step/targets.cpp says.
#include "base/check.hpp"
#include "base/check_values.hpp"
#include "constraints/geometry.hpp"
#include "constraints/plans.hpp"
#include "constraints/row_rule.hpp"

namespace pantin {

namespace {

double evaluate_attract(Row& row, Condition& c, const RowContext&) {
  row.residual = row.d1 - c.position1 - row.offset;
  c.M = identity33();
  c.C = zero33();
  return norm(row.residual);
}

void project_attract(const Row&, Condition& c, bool) { c.kept = identity33(); }

Vec3 attract_gap(const Row& row, const Condition& c) { return row.d1 - c.position1 - row.offset; }

}  // namespace

const RowRule attract_row = {.at_distance = true,
                             .keeps_separation = true,
                             .offsets_gap = true,
                             .evaluate = evaluate_attract,
                             .project = project_attract,
                             .gap = attract_gap};

namespace {

void check(const Model& model, Constraint& c) {
  const Point &first = model.points[c.a], &second = model.points[c.b];
  require(c.a != c.b, "join: both are ", describe(model, c.a), "; it needs two points");
  require(!first.body || first.body != second.body, "join: both points belong to ", describe(model, first.body),
          "; it joins different bodies");
  require(first.particle != second.particle, "join: these points are joined already, in ",
          describe(model, first.particle));
  internal::require_positive_or_infinite("join", "max_force", c.max_force, "N");
}

void start(const Model& model, Constraint& c, double) {
  if (std::isfinite(c.max_force)) return;
  c.attract.away = position(model, c.a) - position(model, c.b);
  c.attract.away_rate = velocity(model, c.a) - velocity(model, c.b);
}

double gap(const Model& model, const Constraint& c) {
  return std::isfinite(c.max_force) ? 0.0 : norm(position(model, c.a) - position(model, c.b) - c.attract.away);
}

std::vector<RowPlan> rows(const Model&, const Constraint& c) {
  return {between_points(c, std::isfinite(c.max_force) ? soft_row : attract_row)};
}

}  // namespace

const ConstraintRule join_rule = {
    .check = check,
    .freedoms =
        [](const Constraint& c) {
          return std::isfinite(c.max_force) ? FreedomsTaken{} : FreedomsTaken{3, 2};
        },
    .directions = all_directions,
    .start = start,
    .gap = gap,
    .rows = rows,
};

}  // namespace pantin
