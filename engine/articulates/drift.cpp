#include "articulates/drift.hpp"

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

#include "articulates/conditions.hpp"
#include "articulates/midpoint.hpp"
#include "articulates/newton.hpp"
#include "articulates/project.hpp"
#include "articulates/rows.hpp"
#include "articulates/safe_step.hpp"
#include "articulates/strand.hpp"

namespace pantin {

namespace {

constexpr int most_halvings = 5;

/// The unknowns have no history but the forces of the last step.
void forget_course(Articulate& a) {
  a.last_h = 0.0;
  for (std::size_t k = 0; k < a.rows.size(); k++) a.rows[k].f = a.forecast.forces[k][0];
}

/// From here on the full sub-step is cut into parts.
void cut(Articulate& a) {
  const double sign = a.sub_steps.count == 1 ? -1.0 : 1.0;
  a.cut = true;
  begin_exerted(a);
  for (std::size_t k = 0; k < a.rows.size(); k++) a.exerted[k] = a.carried[k] * sign;
}

/// A safe step to the end of the part; backwards it makes no sense, so where a full sub-step has parts that go backwards, to
/// its end.
void arrive_safely(Articulate& a, const DriftSettings& settings, double from, double to, DriftReport& report) {
  a.smooth = false;
  a.arrived = settings.backwards;
  if (a.arrived) to = 1.0;
  if (!a.cut) cut(a);
  set_conditions(a, from, to);
  const double h = settings.h * (to - from);
  safe_step(a, settings, h, report);
  add_forces_exerted(a, h);
}

/// Velocities that conditions want at a moment `at` (0 … 1) of the step, by what they want at its end and on the way; at
/// the end again when this goes.
class WantedVelocities {
 public:
  WantedVelocities(Articulate& a, double h, double at) : a_(a) {
    for (const Condition& c : a.conditions) at_end_.push_back({c.velocity, c.length_rate});
    for (const Row& row : a.rows) {
      if (row.condition < 0 || row.lever > 0.0) continue;
      const auto k = static_cast<std::size_t>(row.condition);
      Condition& c = a.conditions[k];
      const Vec3 start = (c.whole1 - c.whole0) / h * 2.0 - c.velocity;
      const double start_rate = (c.whole_length1 - c.whole_length0) / h * 2.0 - c.length_rate;
      c.velocity = start + (c.velocity - start) * at;
      c.length_rate = start_rate + (c.length_rate - start_rate) * at;
    }
  }
  ~WantedVelocities() {
    for (std::size_t k = 0; k < a_.conditions.size(); k++)
      std::tie(a_.conditions[k].velocity, a_.conditions[k].length_rate) = at_end_[k];
  }
  WantedVelocities(const WantedVelocities&) = delete;
  WantedVelocities& operator=(const WantedVelocities&) = delete;

 private:
  Articulate& a_;
  std::vector<std::pair<Vec3, double>> at_end_;
};

/// Puts the ends of nodes and rows where they start, at a moment of the step.
void stand_still(Articulate& a, double at) {
  set_conditions(a, at, at);
  for (Node& n : a.nodes) settle(n);
  place_rows_at_end(a);
}

/// Makes velocities consistent at a moment of the step, where a row is struck or a cut step begins: a solved part turns the
/// sign of what is forbidden, which over several parts no row of one side bears. Returns what this gave beyond the work of
/// what moves by itself [J].
double make_consistent_at(Articulate& a, const DriftSettings& settings, double at, DriftReport& report) {
  const double before = kinetic_energy(a);
  stand_still(a, at);
  const WantedVelocities wanted(a, settings.h, at);
  const ImpulseWork work = make_consistent(a, 0.5 * settings.full);
  report.tell(work);
  return kinetic_energy(a) - before - work.all();
}

void begin_cut(Articulate& a, const DriftSettings& settings, double at, DriftReport& report) {
  cut(a);
  const double given = make_consistent_at(a, settings, at, report);
  report.projected += given;
  a.carried_energy += given;
}

/// Moves over a part of h [s]; false where that cannot be solved, and nothing is changed.
bool solve_part(Articulate& a, const DriftSettings& settings, double h, DriftReport& report) {
  if (settings.ledger) a.saved = a.nodes;
  for (Condition& c : a.conditions) c.held_before = c.held;
  bool solved = solve_step(a, h, settings.gravity, report);
  if (!solved) forget_course(a);
  if (!solved && stall_motors(a, settings.h)) {
    solved = solve_step(a, h, settings.gravity, report);
    if (!solved) forget_course(a);
  }
  if (!solved) {
    for (Condition& c : a.conditions) c.held = c.held_before;
    return false;
  }
  if (settings.ledger) add_unsolved_work(a, h, report);
  for (Condition& c : a.conditions) c.angle0 = c.angle1;
  find_solved_gaps(a);
  a.last_h = h;
  a.safe = false;
  if (a.epsilon < a.most_epsilon && !a.lowered && ++a.good_steps > a.wait) {
    a.epsilon = std::min(a.most_epsilon, 10.0 * a.epsilon);
    a.good_steps = 0;
  }
  return true;
}

/// Moves over the part from … to (0 … 1) of the step.
void drift_part(Articulate& a, const DriftSettings& settings, double from, double to, int depth, DriftReport& report) {
  if (a.arrived) return;
  const double h = settings.h * (to - from);
  set_conditions(a, from, to);
  if (a.gaps.open > 1e-8 * a.length) return arrive_safely(a, settings, from, to, report);
  if (solve_part(a, settings, h, report)) {
    if (!a.cut) return;
    add_forces_exerted(a, h);
    if (struck(a)) report.limit += make_consistent_at(a, settings, to, report);
    for (Condition& c : a.conditions) c.held_before = c.held;
    return;
  }
  const bool stuck = depth == 0 && a.safe;  // since the last step: shorter ones would not help
  if (depth == most_halvings || stuck) return arrive_safely(a, settings, from, to, report);
  report.halved++;
  a.smooth = false;
  if (!a.cut) begin_cut(a, settings, from, report);
  const double middle = 0.5 * (from + to);
  drift_part(a, settings, from, middle, depth + 1, report);
  drift_part(a, settings, middle, to, depth + 1, report);
}

}  // namespace

FirstMeeting meet(Articulate& a, double h, double at) {
  a.edited = a.cut = false;
  stand_still(a, at);
  measure_gaps(a);
  for (Condition& c : a.conditions) c.held = !c.ranged && std::isinf(c.upper);  // of motors the step finds out
  a.torn = a.gaps.open > 1e-8 * a.length;
  if (a.torn) return {};
  const WantedVelocities wanted(a, h, at);
  const double before = kinetic_energy(a);
  make_consistent(a, 0.0);
  const double between = kinetic_energy(a);
  for (Condition& c : a.conditions) c.held = c.held || stop(a, row(a, c)).room < 1e-9 * a.length;
  hold_with_heads(a);
  const ImpulseWork work = make_consistent(a, 0.0);
  const double stopped = kinetic_energy(a) - between - work.all();
  return {between - before + work.all(), stopped};
}

void drift(Articulate& a, const DriftSettings& settings, DriftReport& report) {
  if (a.edited) {
    const FirstMeeting met = meet(a, settings.h, settings.from);
    report.met += met.tied;
    report.limit += met.stopped;
  }
  if (settings.first) {
    strengthen_stalled(a, settings.h);
    const bool carried = take_carried_half(a, settings.full, report);
    a.smooth = true;
    a.arrived = a.cut = false;
    a.exerted_time = 0.0;
    const bool open = a.gaps.open > 1e-8 * a.length;
    if (a.sub_steps.count > 1 && !open) carried ? cut(a) : begin_cut(a, settings, settings.from, report);
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
