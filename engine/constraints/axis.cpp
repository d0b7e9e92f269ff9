// Two axes stay together: d = lever n_b × n_a, and the force along their mean is 0.
#include "constraints/geometry.hpp"
#include "constraints/load.hpp"
#include "constraints/plans.hpp"
#include "constraints/row_rule.hpp"

namespace pantin {

namespace {

double evaluate_axis(Row& row, Condition& c, const RowContext& context) {
  const double kappa = context.kappa();
  const Vec3 n = mean_axis(row), open = row.d1 - row.offset;
  const double along = dot(row.f, n);
  row.residual = open + n * (along * kappa);
  c.M = identity33() - outer(row.rb1, row.rb1);
  c.C = outer(n, n) * kappa;
  return std::fmax(norm(open), std::fabs(along) * kappa);
}

void project_axis(const Row& row, Condition& c, bool) {
  const Vec3 n = direction(row.ra1 + row.rb1);
  c.kept = identity33() - outer(n, n);
}

void read_axes(Row& row, Condition&, const Orientations&) { row.d1 = cross(row.rb1, row.ra1) * row.lever; }

Vec3 axis_gap(const Row& row, const Condition&) { return row.d1 - row.offset; }

}  // namespace

const RowRule axis_row = {.leaves_turn = true,
                          .forbids_as_newton = true,
                          .offsets_gap = true,
                          .read_turn = read_axes,
                          .evaluate = evaluate_axis,
                          .project = project_axis,
                          .gap = axis_gap};

namespace {

double gap(const Model& model, const Constraint& c) {
  return lever(model, c) *
         norm(cross(direction_of(model, c.body_a, c.axis_a), direction_of(model, c.body_b, c.axis_b)));
}

std::vector<RowPlan> rows(const Model&, const Constraint& c) { return {angular_row(c, axis_row)}; }

std::vector<PlaneNeed> in_plane(const Model& model, const Constraint& c) {
  return {{"axis", direction_of(model, c.body_a, c.axis_a), true}};
}

}  // namespace

void load_axis(Condition& condition, const Row& row, const Model& model, const Constraint& c) {
  if (row.rule != &axis_row) return;
  const Quat to_b = c.body_b ? conjugate(model.bodies[c.body_b].axes) : Quat{};
  condition.velocity = c.attract.away_rate * row.lever;
  if (c.body_b) condition.velocity = rotate(orientation(model, c.body_b), condition.velocity);
  condition.velocity = model.plane.about(condition.velocity);
  condition.whole0 = model.plane.about(rotate(to_b, c.attract.previous_away));
  condition.whole1 = model.plane.about(rotate(to_b, c.attract.away));
}

const ConstraintRule axis_rule = {
    .freedoms =
        [](const Constraint&) {
          return FreedomsTaken{2, 0};
        },
    .directions = no_direction,
    .gap = gap,
    .rows = rows,
    .load = load_axis,
    .in_plane = in_plane,
};

}  // namespace pantin
