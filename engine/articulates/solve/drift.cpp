#include "articulates/solve/drift.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "articulates/solve/conditions.hpp"
#include "articulates/solve/corners.hpp"
#include "articulates/solve/couplings.hpp"
#include "articulates/solve/fallback_step.hpp"
#include "articulates/solve/midpoint.hpp"
#include "articulates/solve/moment.hpp"
#include "articulates/solve/momenta.hpp"
#include "articulates/solve/newton.hpp"
#include "articulates/solve/project.hpp"
#include "articulates/solve/row_gaps.hpp"
#include "articulates/solve/state.hpp"
#include "articulates/solve/wanted_velocities.hpp"
#include "constraints/row_rule.hpp"

namespace pantin {

namespace {

constexpr int most_halvings = 5;

/// The unknowns have no history but the forces of the last step.
void forget_history(Articulate& a) {
  a.last_h = 0.0;
  for (std::size_t k = 0; k < a.rows.size(); k++) a.rows[k].f = a.predictor.forces[k][0];
}

/// From … to (0 … 1) of a step, by so many halvings from a part that ends at `end`, after so many corners.
struct Part {
  double from, to, end;
  int depth, corners = 0;
};

/// A fallback step over all that is left of what was halved; backwards it makes no sense, so where a full sub-step has parts
/// that go backwards, to its end. Where nothing may be spent on attempts any more, to the end of the drift.
void fall_back_over(Articulate& a, const DriftSettings& settings, const Part& part, DriftReport& report) {
  a.smooth = false;
  a.moved_to = settings.backwards ? 1.0 : a.effort.spare == 0 ? settings.to : part.end;
  if (!a.sums_impulses) begin_exerted(a);
  set_conditions(a, settings.step, part.from, a.moved_to);
  const double h = settings.step * (a.moved_to - part.from);
  fallback_step(a, settings, h, report);
  add_forces_exerted(a, h);
}

/// Whether the drift is less than its full sub-step, as beside thermostats, and something may strike in it.
bool is_part_that_may_strike(const Articulate& a, const DriftSettings& settings) {
  if (settings.backwards || (settings.to - settings.from) * settings.step > 0.75 * settings.full) return false;
  return std::any_of(a.conditions.begin(), a.conditions.end(), [](const Condition& c) { return c.ranged; });
}

/// How often something is solved that is solved at once.
std::uint32_t parts(const Articulate& a) { return a.sub_steps.count + a.effort.corners; }

/// Some times what a step costs that is solved at once.
std::uint32_t allowance(const Articulate& a, std::uint32_t least, double times) {
  return std::max(least, static_cast<std::uint32_t>(times * a.effort.usual)) * parts(a);
}
/// What attempts that fail may cost, of all parts together: rows without a loop do not contradict each other.
std::uint32_t all_spare(const Articulate& a) { return a.loop_free ? allowance(a, 320, 24.0) : allowance(a, 160, 16.0); }
/// What all attempts may.
std::uint32_t most_cost(const Articulate& a) { return a.loop_free ? allowance(a, 640, 48.0) : allowance(a, 240, 24.0); }

/// Tries to solve a part of h [s]; what a failure costs is spent.
bool try_part(Articulate& a, double h, Vec3 gravity, DriftReport& report) {
  if (cost(report) > most_cost(a)) a.effort.spare = 0;
  if (a.effort.spare == 0) return false;
  const std::uint32_t before = cost(report);
  if (solve_step(a, h, gravity, report)) return true;
  a.effort.spare -= std::min(a.effort.spare, std::max(1u, cost(report) - before));
  forget_history(a);
  return false;
}

/// Moves over a part of h [s]; false where that cannot be solved, and nothing is changed.
bool solve_part(Articulate& a, const DriftSettings& settings, double h, DriftReport& report) {
  constexpr double shortest = 1e-5;  // of the sub-step
  std::optional<PartStart> start;
  if (std::fabs(h) < shortest * std::fabs(settings.full)) start.emplace(a, report);
  if (settings.ledger) a.saved = a.nodes;
  for (Condition& c : a.conditions) c.held_before = c.held;
  const bool expected = !a.expected.empty();
  bool solved = try_part(a, h, settings.gravity, report);
  if (!solved && expected) solved = try_part(a, h, settings.gravity, report);   // from the last forces
  if (!solved && a.lowered) solved = try_part(a, h, settings.gravity, report);  // not from where a softer factor led
  if (!solved && stall_motors(a, settings.step)) {
    a.effort.spare = all_spare(a);  // it is another step now
    solved = try_part(a, h, settings.gravity, report);
  }
  if (!solved) {
    for (Condition& c : a.conditions) c.held = c.held_before;
    return false;
  }
  if (settings.ledger) add_unsolved_work(a, h, report);
  if (acts_at_distance(a)) a.angular_at_distance += angular_momentum_at_distance(a, h);
  for (Condition& c : a.conditions) c.angle0 = c.angle1;
  find_solved_gaps(a);
  a.last_h = h;
  if (start) start->put_back_forces(a, report, h);
  a.fell_back = false;
  if (a.epsilon < a.most_epsilon && !a.lowered && ++a.good_steps > a.wait) {
    a.epsilon = std::min(a.most_epsilon, 10.0 * a.epsilon);
    a.good_steps = 0;
  }
  return true;
}

/// Moves over a part, or up to where the first point is at a sharp corner of its path. Returns the moment up to which it did;
/// none where that cannot be solved: nothing has moved.
std::optional<double> solve_to_corner(Articulate& a, const DriftSettings& settings, const Part& part,
                                      DriftReport& report) {
  const auto solve = [&](double to) {
    set_conditions(a, settings.step, part.from, to);
    return solve_part(a, settings, settings.step * (to - part.from), report);
  };
  if (!has_sharp_corners(a)) return solve(part.to) ? std::optional(part.to) : std::nullopt;
  PartStart start(a, report);
  if (!solve(part.to)) return {};
  CornerSearch search(a, settings.step * (part.to - part.from));
  if (search.none_passed()) return part.to;
  start.put_back(a, report);
  a.effort.corners++;
  a.smooth = false;
  if (!a.sums_impulses) begin_cut(a, settings, part.from, report);
  start = PartStart(a, report);
  for (search.begin(a); !search.done(); search.tell(a)) {
    start.put_back(a, report);
    if (search.at_start()) return part.from;
    if (!solve(part.from + (part.to - part.from) * search.next())) return {};
  }
  return part.from + (part.to - part.from) * search.last();
}

void drift_part(Articulate& a, const DriftSettings& settings, const Part& part, DriftReport& report);

/// Goes on round a sharp corner that it is at; what came back to it in this step stays there, and so does all once that took
/// much.
void go_round(Articulate& a, const DriftSettings& settings, const Part& part, double at, DriftReport& report) {
  constexpr int most_corners = 100;
  constexpr std::uint32_t most_factorisations = 200;
  const bool took_much = part.corners >= most_corners || a.report.factorisations > most_factorisations;
  turn_at_corners(a, settings, at, took_much, report);
  drift_part(a, settings, {at, part.to, part.end, part.depth, part.corners + 1}, report);
}

/// Moves over a part: solved at once, by its halves, or by a fallback step that may go further than the part.
void drift_part(Articulate& a, const DriftSettings& settings, const Part& part, DriftReport& report) {
  if (part.from < a.moved_to) return;
  set_conditions(a, settings.step, part.from, part.to);
  if (is_open(a)) return fall_back_over(a, settings, part, report);
  if (const std::optional<double> reached = solve_to_corner(a, settings, part, report)) {
    if (!a.sums_impulses) return;
    const double h = settings.step * (*reached - part.from);
    if (h != 0.0) add_forces_exerted(a, h);
    if (struck(a)) report.limit += make_consistent_at(a, settings, *reached, report, h);
    for (Condition& c : a.conditions) c.held_before = c.held;
    if (*reached != part.to) go_round(a, settings, part, *reached, report);
    return;
  }
  const bool failed_before = part.depth == 0 && a.fell_back;  // since the last step: shorter ones would not help
  if (part.depth == most_halvings || failed_before || a.effort.spare == 0)
    return fall_back_over(a, settings, part, report);
  report.halved++;
  a.smooth = false;
  if (!a.sums_impulses) begin_cut(a, settings, part.from, report);
  const double middle = 0.5 * (part.from + part.to);
  drift_part(a, settings, {part.from, middle, part.end, part.depth + 1}, report);
  drift_part(a, settings, {middle, part.to, part.end, part.depth + 1}, report);
}

}  // namespace

EnergyOfConsistency make_start_consistent(Articulate& a, double step, double at) {
  a.edited = a.sums_impulses = false;
  stand_still(a, step, at);
  measure_gaps(a);
  for (Condition& c : a.conditions)  // of motors and ends of paths the step finds out
    c.held = !c.ranged && std::isinf(c.upper) && !row(a, c).rule->held_at_end;
  a.torn = is_open(a);
  if (a.torn) return {};
  const WantedVelocities wanted(a, step, at);
  const bool free = is_free(a);
  const Momenta momenta = free ? momenta_of(a) : Momenta{};
  const double before = kinetic_energy(a);
  make_consistent(a, 0.0);
  const double between = kinetic_energy(a);
  for (Condition& c : a.conditions) c.held = c.held || stop(a, row(a, c)).room < 1e-9 * a.length;
  hold_with_heads(a);
  const ImpulseWork work = make_consistent(a, 0.0);
  if (free) restore_momenta(a, momenta);
  const double stopped = kinetic_energy(a) - between - work.all();
  return {between - before + work.all(), stopped};
}

namespace {

/// After a step that could not be solved the next are tried with little, and the longer that lasts the more seldom.
void begin_effort(Articulate& a) {
  Effort& effort = a.effort;
  if (a.edited) effort.failed = effort.pause = 0;
  const bool waits = effort.pause > 0;
  if (waits) effort.pause--;
  effort.corners = 0;
  effort.spare = waits ? 0 : effort.failed > 0 ? allowance(a, 16, 3.0) : all_spare(a);
}

/// `spare`: what attempts might spend; `open`: the drift began with a gap, so that none was made.
void end_effort(Articulate& a, std::uint32_t spare, bool open, const DriftReport& report) {
  constexpr std::uint16_t longest_pause = 8;
  Effort& effort = a.effort;
  if (report.fallbacks == 0 && report.halved == 0) effort.usual += (1.0 * cost(report) / parts(a) - effort.usual) / 8.0;
  if (report.fallbacks == 0) {
    effort.failed = 0;
  } else if (spare > 0 && !open) {
    effort.failed = static_cast<std::uint16_t>(std::min(effort.failed + 1, int{most_failed}));
    effort.pause = std::min(longest_pause, static_cast<std::uint16_t>((1u << effort.failed) - 1u));
  }
}

}  // namespace

void drift_midpoint(Articulate& a, const DriftSettings& settings, DriftReport& report) {
  drop_factor(a, FactorOf::projection);
  begin_effort(a);
  for (Condition& c : a.conditions) c.turned_at = infinity;
  if (a.edited) {
    const EnergyOfConsistency gave = make_start_consistent(a, settings.step, settings.from);
    report.after_edit += gave.tied;
    report.limit += gave.stopped;
  }
  if (settings.first) {
    strengthen_stalled(a, settings.step);
    const bool symmetric = project_symmetrically(a, settings.full, report);
    a.smooth = true;
    a.moved_to = 0.0;
    a.sums_impulses = false;
    a.exerted_time = 0.0;
    const bool open = is_open(a);
    if ((a.sub_steps.count > 1 || is_part_that_may_strike(a, settings)) && !open)
      symmetric ? begin_exerted(a) : begin_cut(a, settings, settings.from, report);
  }
  const std::uint32_t count = a.sub_steps.count, spare = a.effort.spare;
  const bool open = is_open(a);
  const double sub_step = (settings.to - settings.from) / count;  // of the step
  for (std::uint32_t i = 0; i < count; i++) {
    const double to = i + 1 == count ? settings.to : settings.from + sub_step * (i + 1);
    drift_part(a, settings, {settings.from + sub_step * i, to, to, 0}, report);
  }
  end_effort(a, spare, open, report);
  if (a.torn) report.after_edit += std::exchange(report.dissipated, 0.0);  // drawing together what an edit tore apart
  a.torn = a.torn && is_open(a);
}

}  // namespace pantin
