#include "articulates/drift.hpp"

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

#include "articulates/conditions.hpp"
#include "articulates/midpoint.hpp"
#include "articulates/newton.hpp"
#include "articulates/project.hpp"
#include "articulates/safe_step.hpp"

namespace pantin {

namespace {

constexpr int most_halvings = 5;

/// The unknowns have no history but the forces of the last step.
void forget_course(Articulate& a) {
  a.last_h = 0.0;
  for (std::size_t k = 0; k < a.rows.size(); k++) a.rows[k].f = a.forecast.forces[k][0];
}

/// A safe step to the end of the part; backwards it makes no sense, so where a full sub-step has parts that go backwards, to
/// its end.
void arrive_safely(Articulate& a, const DriftSettings& settings, double from, double to, DriftReport& report) {
  a.smooth = false;
  a.arrived = settings.backwards;
  if (a.arrived) to = 1.0;
  set_conditions(a, from, to);
  for (Condition& c : a.conditions) c.held = c.held && std::isinf(c.most);
  safe_step(a, settings, settings.h * (to - from), report);
}

/// Moves over the part from … to (0 … 1) of the step.
void drift_part(Articulate& a, const DriftSettings& settings, double from, double to, int depth, DriftReport& report) {
  if (a.arrived) return;
  const double h = settings.h * (to - from);
  set_conditions(a, from, to);
  if (a.gaps.open > 1e-8 * a.length) return arrive_safely(a, settings, from, to, report);
  if (settings.ledger) a.saved = a.nodes;
  bool solved = solve_step(a, h, settings.gravity, report);
  if (!solved) forget_course(a);
  if (!solved && stall_motors(a, settings.h)) {
    solved = solve_step(a, h, settings.gravity, report);
    if (!solved) forget_course(a);
  }
  if (solved) {
    if (settings.ledger) add_unsolved_work(a, h, report);
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
  const bool stuck = depth == 0 && a.safe;  // since the last step: shorter ones would not help
  if (depth == most_halvings || stuck) return arrive_safely(a, settings, from, to, report);
  report.halved++;
  a.smooth = false;
  const double middle = 0.5 * (from + to);
  drift_part(a, settings, from, middle, depth + 1, report);
  drift_part(a, settings, middle, to, depth + 1, report);
}

/// Velocities that conditions want of points at the start of the step, by what they want at its end and on the way; their
/// own are put into `at_end`.
void want_start(Articulate& a, double h, std::vector<std::pair<Vec3, double>>& at_end) {
  at_end.clear();
  for (const Condition& c : a.conditions) at_end.push_back({c.velocity, c.length_rate});
  for (const Row& row : a.rows) {
    if (row.condition < 0 || row.lever > 0.0) continue;
    const auto k = static_cast<std::size_t>(row.condition);
    Condition& c = a.conditions[k];
    c.velocity = (c.whole1 - c.whole0) / h * 2.0 - at_end[k].first;
    c.length_rate = (c.whole_length1 - c.whole_length0) / h * 2.0 - at_end[k].second;
  }
}

/// Makes velocities consistent with those of the start of the step.
void make_start_consistent(Articulate& a, double h) {
  std::vector<std::pair<Vec3, double>> at_end;
  want_start(a, h, at_end);
  make_consistent(a);
  for (std::size_t k = 0; k < a.conditions.size(); k++)
    std::tie(a.conditions[k].velocity, a.conditions[k].length_rate) = at_end[k];
}

}  // namespace

void drift(Articulate& a, const DriftSettings& settings, DriftReport& report) {
  if (a.edited) {
    set_conditions(a, settings.from, settings.from);
    for (Node& n : a.nodes) settle(n);
    place_rows_at_end(a);
    measure_gaps(a);
    for (Condition& c : a.conditions) c.held = !c.ranged && std::isinf(c.upper);  // the step finds out
    if (a.gaps.open <= 1e-8 * a.length) {
      const double before = kinetic_energy(a);
      make_start_consistent(a, settings.h);
      report.met += kinetic_energy(a) - before;
    } else {
      a.torn = true;
    }
    a.edited = false;
  }
  if (settings.first) {
    if (settings.from > 0.0)
      for (Condition& c : a.conditions) c.held_before = c.held;
    take_carried_half(a, settings.full, report);
    a.smooth = true;
    a.arrived = false;
  }
  const std::uint32_t count = a.sub_steps.count;
  const double way = (settings.to - settings.from) / count;
  for (std::uint32_t i = 0; i < count; i++)
    drift_part(a, settings, settings.from + way * i, i + 1 == count ? settings.to : settings.from + way * (i + 1), 0,
               report);
  if (a.torn && report.dissipated > 0.0) {  // drawing together what an edit tore apart lifted something
    report.met += report.dissipated;
    report.dissipated = 0.0;
  }
  a.torn = a.torn && a.gaps.open > 1e-8 * a.length;
}

}  // namespace pantin
