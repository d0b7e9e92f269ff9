// A follow with a limit: a damped spring taken at the end of the step (backward, dissipative), whose pull saturates:
//   z = (k + d/h) d1 - (d/h) d0,   f = -z min(1, F/|z|).
#include "articulates/rows.hpp"

namespace pantin {

double evaluate_limited(Row& row, const RowContext& context) {
  const double k = row.stiffness + row.damping / context.h;
  const Vec3 z = row.d1 * k - row.d0 * (row.damping / context.h);
  const double pull = norm(z);
  row.C = identity33();
  if (pull <= row.max_force) {
    row.residual = row.f + z;
    row.M = row.C * k;
    return norm(row.residual) / k;
  }
  const Vec3 u = z / pull;
  const double secant = k * row.max_force / pull;
  row.residual = row.f + u * row.max_force;
  row.M = (row.C - outer(u, u)) * secant;
  return norm(row.residual) / secant;
}

void project_limited(Row& row) {
  row.M = zero33();
  row.C = identity33();
}

}  // namespace pantin
