// Rows of one dimension: what rods, planes, angles and limits share.
#include <algorithm>

#include "constraints/row_rule.hpp"

namespace pantin {

namespace {

/// What keeps a row: a gap to close, or, where it is not held, a force to have.
struct Hold {
  bool held;
  double gap, force;
};

Hold hold(const Condition& c, const ConstraintFunction& r, double along, double kappa) {
  if (c.ranged) {
    if (along * kappa < r.above_high) return {true, r.above_high, 0.0};
    if (along * kappa > r.above_low) return {true, r.above_low, 0.0};
    return {false, 0.0, 0.0};
  }
  const double closing_force = along - r.above_low / kappa;
  if (closing_force < c.lower) return {false, 0.0, c.lower};
  if (closing_force > c.upper) return {false, 0.0, c.upper};
  return {true, r.above_low, 0.0};
}

}  // namespace

double evaluate_function(Row& row, Condition& c, const ConstraintFunction& r, const RowContext& context) {
  const double kappa = context.kappa();
  const double along = dot(row.f, r.n);
  const Hold h = hold(c, r, along, kappa);
  c.held = h.held;
  if (!h.held) {
    row.residual = (row.f - r.n * h.force) * kappa;
    c.M = (identity33() - outer(r.n, r.n)) * (-kappa * h.force * r.turn_of_n);
    c.C = identity33() * kappa;
    return norm(row.residual);
  }
  const Vec3 across = row.f - r.n * along;
  const Mat3 P = identity33() - outer(r.n, r.n);
  row.residual = r.n * h.gap + across * kappa;
  c.M = outer(r.n, r.gradient) - P * (kappa * along * r.turn_of_n);
  c.C = P * kappa;
  return std::fmax(std::fabs(h.gap), norm(across) * length_per_force(norm(row.f), r.displacement, kappa));
}

void project_function(Condition& c, Vec3 gradient, bool holds, double slope) {
  c.kept = zero33();
  if (!holds) return;
  const Vec3 n = direction(gradient);
  c.kept = outer(n, n);
  c.wanted += n * (c.value_rate / slope);
}

double missing(const Condition& c, double low, double high) {
  if (c.ranged) return std::fmax(high, 0.0) + std::fmin(low, 0.0);
  return std::isinf(c.upper) && std::isinf(c.stall_force) ? low : 0.0;
}

}  // namespace pantin
