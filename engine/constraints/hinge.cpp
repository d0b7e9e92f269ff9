// Hinge, nail, rigid follow, weld and orient: two points, or two orientations, stay together. M = 1 and C = 0 are left out
// of the products.
#include "constraints/row_rule.hpp"

namespace pantin {

namespace {

double evaluate_rigid(Row& row, Condition&, const RowContext&) {
  row.residual = row.d1 - row.offset;
  return norm(row.residual);
}

Vec3 rigid_gap(const Row& row, const Condition&) { return row.d1 - row.offset; }

}  // namespace

const RowRule rigid_row = {.offsets_gap = true, .evaluate = evaluate_rigid, .gap = rigid_gap};

}  // namespace pantin
