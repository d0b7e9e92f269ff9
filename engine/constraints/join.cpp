// A join: two points are `position1` apart at the end of the step, which goes to 0 as `conditions` say.
#include "constraints/row_rule.hpp"

namespace pantin {

double evaluate_attract(Row& row, Condition& c, const RowContext&) {
  row.residual = row.d1 - c.position1 - row.offset;
  c.M = identity33();
  c.C = zero33();
  return norm(row.residual);
}

void project_attract(const Row&, Condition& c) { c.kept = identity33(); }

Vec3 attract_gap(const Row& row, const Condition& c) { return row.d1 - c.position1 - row.offset; }

}  // namespace pantin
