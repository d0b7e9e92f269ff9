// Hinge, nail and rigid follow: two points stay together. M = 1 and C = 0 are left out of the products.
#include "articulates/rows.hpp"

namespace pantin {

double evaluate_rigid(Row& row, const RowContext&) {
  row.residual = row.d1 - row.offset;
  return norm(row.residual);
}

void project_rigid(Row&) {}

const RowRule row_rules[3] = {
    {evaluate_rigid, project_rigid},
    {evaluate_limited, project_limited},
    {evaluate_rod, project_rod},
};

}  // namespace pantin
