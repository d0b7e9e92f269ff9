// A rod: g = (|d1|² - L²)/2L = 0 by a force along the mean direction d̄ = (d0 + d1)/2, so that force times displacement is
// λ Δg exactly (discrete gradient; Gonzalez 1996). The force is a 3-vector like any row's, held to d̄ by two equations:
//   n g + κ P f = 0,  n = d̄/|d̄|,  P = 1 - n n',  κ = (h²/2) mobility to make a force a length.
#include "articulates/rows.hpp"

namespace pantin {

double evaluate_rod(Row& row, Condition& c, const RowContext& context) {
  const Vec3 middle = (row.d0 + row.d1) * 0.5;
  const double reach = norm(middle), kappa = 0.5 * context.h * context.h * context.mobility;
  const Vec3 n = direction(middle);
  const double length = c.length + c.accepted;
  const double g = (dot(row.d1, row.d1) - length * length) / (2.0 * length);
  const double along = dot(row.f, n);
  const Vec3 across = row.f - n * along;
  const Mat3 P = identity33() - outer(n, n);
  row.residual = n * g + across * kappa;
  c.M = outer(n, row.d1 / length) - P * (kappa * along / (2.0 * std::fmax(reach, 1e-3 * length)));
  c.C = P * kappa;
  // A force across the rod does work on its turning: it counts as the gap that would do as much.
  const double way = norm(row.d1 - row.d0);
  const double weight = std::fmax(kappa, way / std::fmax(norm(row.f), 1e-3 * way / kappa));
  return std::fmax(std::fabs(g), norm(across) * weight);
}

void project_rod(const Row& row, Condition& c) {
  const Vec3 n = direction(row.d1);
  c.M = outer(n, n);
  c.C = (identity33() - c.M);
}

}  // namespace pantin
