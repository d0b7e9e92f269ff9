// A motor or a limit: the angle about an axis, driven to a value or kept in a range.
#include "base/functions.hpp"
#include "constraints/row_rule.hpp"

namespace pantin {

namespace {

/// A motor that stalls: its force grows with what it misses.
double evaluate_yielding(Row& row, Condition& c, const ConstraintFunction& r, const RowContext& context) {
  const double kappa = context.kappa(), to_metres = kappa / (1.0 + kappa / c.yields_by);
  const double wanted = -r.above_low / c.yields_by, given = std::fmin(c.upper, std::fmax(c.lower, wanted));
  c.held = false;
  row.residual = (row.f - r.n * given) * to_metres;
  c.M = given == wanted ? outer(r.n, r.gradient) * (to_metres / c.yields_by) : zero33();
  c.C = identity33() * to_metres;
  return norm(row.residual);
}

double evaluate_turn(Row& row, Condition& c, const RowContext& context) {
  const double value = c.angle1 * row.lever - c.accepted;
  const double low = c.ranged ? low_end(c) : c.kept_value, high = c.ranged ? high_end(c) : c.kept_value;
  const ConstraintFunction function{mean_axis(row), angle_gradient(row), value - low, value - high};
  if (std::isfinite(c.stall_force)) return evaluate_yielding(row, c, function, context);
  return evaluate_function(row, c, function, context);
}

void project_turn(const Row& row, Condition& c, bool holds) {
  const Vec3 gradient = angle_gradient(row);
  project_function(c, gradient, holds,
                   std::fmax(1.0, norm(gradient)));  // less only where the axes are opposite, and it has none
}

Stop stop_of_turn(const Row& row, const Condition& c) {
  const double value = c.angle1 * row.lever - c.accepted;
  return nearer_end(direction(angle_gradient(row)), value - low_end(c), value - high_end(c));
}

Vec3 turn_gap(const Row& row, const Condition& c) {
  const double value = c.angle1 * row.lever - c.accepted;
  return direction(angle_gradient(row)) *
         missing(c, value - (c.ranged ? low_end(c) : c.kept_value), value - (c.ranged ? high_end(c) : c.kept_value));
}

}  // namespace

const RowRule turn_row = {.about_axis = true,
                          .read_turn = count_angle,
                          .evaluate = evaluate_turn,
                          .project = project_turn,
                          .gap = turn_gap,
                          .stop = stop_of_turn};

void count_angle(Row& row, Condition& c, const Orientations& nodes) {
  constexpr double pi = 3.14159265358979323846;
  const Quat violation = nodes.violation(c.turn1);
  const double angle = 2.0 * functions::atan2(dot(vec(violation.x, violation.y, violation.z), row.la), violation.w);
  c.angle1 = angle - 2.0 * pi * std::nearbyint((angle - c.angle0) / (2.0 * pi));
}

}  // namespace pantin
