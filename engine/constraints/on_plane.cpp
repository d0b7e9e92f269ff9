// A point on a plane: n·(y - c) = 0 by a force along n. Linear, so that the force does no work.
#include "constraints/row_rule.hpp"

namespace pantin {

double evaluate_plane(Row& row, Condition& c, const RowContext& context) {
  const double height = dot(c.normal, row.d1) - c.accepted;
  return evaluate_function(row, c, {c.normal, c.normal, height, height, 0.0, norm(row.d1 - row.d0)}, context);
}

void project_plane(const Row&, Condition& c) { project_function(c, c.normal); }

Vec3 plane_gap(const Row& row, const Condition& c) { return c.normal * (dot(c.normal, row.d1) - c.accepted); }

}  // namespace pantin
