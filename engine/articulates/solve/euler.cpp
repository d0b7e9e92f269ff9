#include <algorithm>

#include "articulates/solve/angular_rows.hpp"
#include "articulates/solve/conditions.hpp"
#include "articulates/solve/couplings.hpp"
#include "articulates/solve/drift.hpp"
#include "articulates/solve/fallback_step.hpp"
#include "articulates/solve/matrix.hpp"
#include "articulates/solve/midpoint.hpp"
#include "articulates/solve/newton.hpp"
#include "articulates/solve/row_gaps.hpp"
#include "articulates/solve/state.hpp"
#include "base/rotation.hpp"
#include "constraints/row_rule.hpp"

namespace pantin {

namespace {

/// End of the step from row_force and the moment of the row forces about the centre, world axes.
void evaluate_euler(Node& n, double h) {
  n.p1 = n.p0 + (n.row_force + n.force) * h;
  n.x1 = n.x0 + n.p1 * (h * n.inverse_mass);
  if (!n.turns) return;
  const Vec3 L = n.R0 * n.P0 + (n.row_torque + n.torque) * h;
  const Vec3 turn = n.inverse_inertia * transposed_times(n.R0, L) * h;
  n.cayley = n.R0 * turn;
  n.q1 = n.q0 * quaternion_of(turn);
  n.R1 = matrix(n.q1);
  n.P1 = transposed_times(n.R1, L);
}

/// State and residuals for the present forces; returns the largest residual [m].
double evaluate_euler(Articulate& a, double h) {
  for (Node& n : a.nodes) n.row_force = n.row_torque = zero3();
  for (const Row& row : a.rows) {
    Node& first = a.nodes[static_cast<std::size_t>(row.a)];
    add_row_force(first, row, first.R0 * row.la, row.f);
    if (row.b < 0) continue;
    Node& second = a.nodes[static_cast<std::size_t>(row.b)];
    add_row_force(second, row, second.R0 * row.lb, row.f * -1.0);
  }
  for (Node& n : a.nodes) evaluate_euler(n, h);
  place_rows_at_end(a);
  double worst = 0.0;
  for (Row& row : a.rows) {
    const double r = residual(a, row, h);
    if (!std::isfinite(r)) return infinity;
    worst = std::max(worst, r);
  }
  return std::max(worst, evaluate_couplings(a, h));
}

/// Newton with line backtracking on the positions at the end; false where it finds no better ones.
bool solve_euler(Articulate& a, double h, Vec3 gravity, DriftReport& report) {
  const double tolerance = 1e-11 * a.length + 1e-10 * h * std::sqrt(norm(gravity) * a.length);
  double e = evaluate_euler(a, h);
  for (int i = 0; i < 40 && e > tolerance; i++) {
    factorise(a, {.right = Arms::start, .epsilon = 1e-10, .times_C = 1.0 / (h * h), .times_residual = -1.0 / (h * h)});
    report.factorisations++;
    solve_hubs(a);
    for (std::size_t k = a.rows.size(); k-- > 0;) {
      a.factor.substitute_back(static_cast<std::uint32_t>(k), a.right_side.data());
      a.f_saved[k] = a.rows[k].f;
    }
    double fraction = 1.0, e1 = infinity;
    for (int halvings = 0; halvings <= 8; halvings++, fraction *= 0.5) {
      for (std::size_t k = 0; k < a.rows.size(); k++) a.rows[k].f = a.f_saved[k] + a.right_side[k] * fraction;
      e1 = evaluate_euler(a, h);
      report.iterations++;
      if (e1 < e * (1.0 - 0.1 * fraction) || e1 <= tolerance) break;
    }
    if (!(e1 < e)) return false;
    e = e1;
  }
  return e <= 100.0 * tolerance;
}

}  // namespace

void drift_euler(Articulate& a, const DriftSettings& settings, DriftReport& report) {
  set_conditions(a, settings.step, 0.0, 1.0);
  place_rows_at_start(a);
  a.last_h = 0.0;
  drop_factor(a, FactorOf::newton);
  a.sums_impulses = false;
  a.exerted_time = 0.0;
  if (!solve_euler(a, settings.step, settings.gravity, report))
    return fallback_step(a, settings, settings.step, report);
  add_work_of_rows(a, report);
  for (Node& n : a.nodes) {
    report.hand += dot(n.force - settings.gravity * n.mass, n.x1 - n.x0);
    if (n.turns) report.hand += dot(n.torque, n.cayley);
    commit(n);
  }
  measure_gaps(a);
  a.fell_back = false;
}

void drift_euler_alone(Node& n, double h) {
  n.row_force = n.row_torque = zero3();
  evaluate_euler(n, h);
  commit(n);
}

}  // namespace pantin
