// Two axes stay together: d = lever n_b × n_a, and the force along their mean is 0.
#include "constraints/row_rule.hpp"

namespace pantin {

double evaluate_axis(Row& row, Condition& c, const RowContext& context) {
  const double kappa = 0.5 * context.h * context.h * context.mobility;
  const Vec3 n = mean_axis(row), open = row.d1 - row.offset;
  const double along = dot(row.f, n);
  row.residual = open + n * (along * kappa);
  c.M = identity33() - outer(row.rb1, row.rb1);
  c.C = outer(n, n) * kappa;
  return std::fmax(norm(open), std::fabs(along) * kappa);
}

void project_axis(const Row& row, Condition& c) {
  const Vec3 n = direction(row.ra1 + row.rb1);
  c.kept = identity33() - outer(n, n);
}

Vec3 axis_gap(const Row& row, const Condition&) { return row.d1 - row.offset; }

}  // namespace pantin
