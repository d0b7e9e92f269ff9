#include "articulates/drift.hpp"

#include <algorithm>

#include "articulates/conditions.hpp"
#include "articulates/midpoint.hpp"
#include "articulates/newton.hpp"
#include "articulates/project.hpp"
#include "articulates/safe_step.hpp"

namespace pantin {

namespace {

constexpr int most_halvings = 5;

/// Makes the end of the step just solved the start of the next; tells the work of the rows, and of pushes and twists.
void commit(Articulate& a, Vec3 gravity, DriftReport& report) {
  add_work_of_rows(a, report);
  for (Node& n : a.nodes) {
    report.work += dot(n.force - gravity * n.mass, n.x1 - n.x0);
    if (n.turns) report.work += dot(n.torque, n.a);
    commit(n);
  }
}

/// Moves over the part from … to (0 … 1) of the step.
void drift_part(Articulate& a, const DriftSettings& settings, double from, double to, int depth, DriftReport& report) {
  const double h = settings.h * (to - from);
  set_conditions(a, from, to);
  if (a.gaps.open > 1e-8 * a.length) return safe_step(a, settings, h, report);
  if (solve_step(a, h, settings.gravity, report)) {
    commit(a, settings.gravity, report);
    for (Condition& c : a.conditions) c.angle0 = c.angle1;
    measure_gaps(a);
    a.last_h = h;
    a.safe = false;
    if (a.epsilon < a.most_epsilon && !a.lowered && ++a.good_steps > a.wait) {
      a.epsilon = std::min(a.most_epsilon, 10.0 * a.epsilon);
      a.good_steps = 0;
    }
    return;
  }
  a.last_h = 0.0;
  for (std::size_t k = 0; k < a.rows.size(); k++) a.rows[k].f = a.forecast.forces[k][0];
  if (depth == most_halvings) return safe_step(a, settings, h, report);
  report.halved++;
  const double middle = 0.5 * (from + to);
  drift_part(a, settings, from, middle, depth + 1, report);
  drift_part(a, settings, middle, to, depth + 1, report);
}

}  // namespace

void drift(Articulate& a, const DriftSettings& settings, DriftReport& report) {
  if (a.edited) {
    set_conditions(a, 0.0, 0.0);
    place_rows_at_end(a);
    measure_gaps(a);
    for (Condition& c : a.conditions) c.held = !c.ranged && std::isinf(c.upper);  // the step finds out
    if (a.gaps.open <= 1e-8 * a.length) {
      const double before = kinetic_energy(a);
      make_consistent(a);
      report.met += kinetic_energy(a) - before;
    }
    a.edited = false;
  }
  drift_part(a, settings, 0.0, 1.0, 0, report);
}

}  // namespace pantin
