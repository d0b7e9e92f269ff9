#include "articulates/solve/row_gaps.hpp"

#include "articulates/solve/couplings.hpp"
#include "articulates/solve/matrix.hpp"

namespace pantin {

double residual(Articulate& a, Row& row, double h) {
  if (is_rigid(row)) {
    row.residual = row.d1 - row.offset;
    return norm(row.residual);
  }
  return row.rule->evaluate(row, condition(a, row), {h, mobility(a, row)});
}

Vec3 gap(const Articulate& a, const Row& row) {
  if (is_rigid(row)) return row.d1 - row.offset;
  if (is_coupled(row)) return coupling_gap_of(a, row);
  return row.rule->gap(row, condition(a, row));
}

Stop stop(const Articulate& a, const Row& row) {
  return is_coupled(row) ? coupling_stop(a, row) : row.rule->stop(row, condition(a, row));
}

void accept_gap(Articulate& a, Row& row) {
  const Vec3 open = gap(a, row);
  if (row.rule->offsets_gap) {
    row.offset += open;
    return;
  }
  Condition& c = condition(a, row);
  const double size = norm(open);
  c.accepted += size;
  if (norm(gap(a, row)) > size) c.accepted -= 2.0 * size;
}

}  // namespace pantin
