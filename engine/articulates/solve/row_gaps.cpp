#include "articulates/solve/row_gaps.hpp"

#include "articulates/solve/couplings.hpp"
#include "articulates/solve/newton.hpp"

namespace pantin {

double residual(Articulate& a, Row& row, double h) {
  if (row.kind == RowKind::rigid) {
    row.residual = row.d1 - row.offset;
    return norm(row.residual);
  }
  return rule(row).evaluate(row, condition(a, row), {h, mobility(a, row)});
}

Vec3 gap(const Articulate& a, const Row& row) {
  if (row.kind == RowKind::rigid) return row.d1 - row.offset;
  if (row.kind == RowKind::coupled) return coupling_gap_of(a, row);
  return rule(row).gap(row, condition(a, row));
}

Stop stop(const Articulate& a, const Row& row) {
  return row.kind == RowKind::coupled ? coupling_stop(a, row) : rule(row).stop(row, condition(a, row));
}

void accept_gap(Articulate& a, Row& row) {
  const Vec3 open = gap(a, row);
  if (rule(row).offsets_gap) {
    row.offset += open;
    return;
  }
  Condition& c = condition(a, row);
  const double size = norm(open);
  c.accepted += size;
  if (norm(gap(a, row)) > size) c.accepted -= 2.0 * size;
}

}  // namespace pantin
