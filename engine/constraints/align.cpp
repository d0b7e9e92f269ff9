// The angle between two axes, by torques across both: ū_b × ū_a of the means, which does work on cos θ exactly.
#include "base/functions.hpp"
#include "constraints/row_rule.hpp"

namespace pantin {

namespace {

double angle_between(const Row& row) { return functions::atan2(norm(cross(row.rb1, row.ra1)), dot(row.rb1, row.ra1)); }

}  // namespace

double evaluate_align(Row& row, Condition& c, const RowContext& context) {
  const double value = angle_between(row) * row.lever - c.length - c.accepted;
  return evaluate_function(
      row, c,
      {direction(cross(row.rb0 + row.rb1, row.ra0 + row.ra1)), direction(cross(row.rb1, row.ra1)), value, value},
      context);
}

void project_align(const Row& row, Condition& c) { project_function(c, cross(row.rb1, row.ra1)); }

Vec3 align_gap(const Row& row, const Condition& c) {
  return direction(cross(row.rb1, row.ra1)) * (angle_between(row) * row.lever - c.length - c.accepted);
}

}  // namespace pantin
