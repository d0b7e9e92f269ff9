// Hinge, nail and rigid follow: two points stay together. M = 1 and C = 0 are left out of the products.
#include "articulates/newton.hpp"
#include "articulates/rows.hpp"

namespace pantin {

namespace {

double evaluate_rigid(Row& row) {
  row.residual = row.d1 - row.offset;
  return norm(row.residual);
}

}  // namespace

const RowRule row_rules[3] = {
    {[](Row& row, Condition&, const RowContext&) { return evaluate_rigid(row); }, [](const Row&, Condition&) {}},
    {evaluate_limited, project_limited},
    {evaluate_rod, project_rod},
};

double residual(Articulate& a, Row& row, double h) {
  if (row.kind == RowKind::rigid) return evaluate_rigid(row);
  return rule(row).evaluate(row, condition(a, row), {h, mobility(a, row)});
}

}  // namespace pantin
