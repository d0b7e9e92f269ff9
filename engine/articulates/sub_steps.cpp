#include "articulates/sub_steps.hpp"

#include <algorithm>
#include <utility>

#include "articulates/drift.hpp"
#include "articulates/loose.hpp"

namespace pantin {

namespace {

constexpr std::uint16_t patience = 64, longest_wait = 16;
constexpr double whole_turn = 1.0;  // [rad] that a body without rows turns by at once
constexpr double fast = 0.3;        // [rad] in a sub-step: then each step is a trial

constexpr double second_order = 4.0, fourth_order = 16.0;  // the error falls by this much with twice as many sub-steps

/// An error so small counts as quiet: half as many sub-steps have `gain` times as much, and need some room.
bool is_quiet(const SubSteps& n, double rate, double accuracy, double gain) {
  return n.count > 1 && 2.0 * gain * rate <= accuracy;
}

SubSteps halved(const SubSteps& n) { return {static_cast<std::uint16_t>(n.count / 2)}; }

/// Whether to try now, for a thing that turns by `turn` [rad] in a sub-step.
bool is_due(SubSteps& n, const SubStepSettings& wanted, double turn) {
  if (wanted.accuracy == 0.0 || !wanted.trials) return false;
  if (n.left > 0) n.left--;
  return n.left == 0 || turn > fast;
}

/// Angle between two orientations, if small [rad].
double turn_between(const Mat3& a, const Mat3& b) {
  return std::sqrt(0.5 * (norm2(a[0] - b[0]) + norm2(a[1] - b[1]) + norm2(a[2] - b[2])));
}

/// Largest distance of a point of the body between its two ends [m].
double distance(const Node& a, const Node& b) {
  const double moved = norm(a.x0 - b.x0);
  if (!a.turns) return moved;
  const double extent = std::max(a.reach, std::sqrt(largest(a.inertia) * a.inverse_mass));
  return moved + extent * turn_between(a.R0, b.R0);
}

double difference(const Articulate& a, const Articulate& b) {
  double worst = 0.0;
  for (std::size_t i = 0; i < a.nodes.size(); i++) worst = std::max(worst, distance(a.nodes[i], b.nodes[i]));
  return worst / a.length;
}

double fastest_spin(const Articulate& a) {
  double fastest = 0.0;
  for (const Node& n : a.nodes) fastest = std::max(fastest, norm2(n.O0));
  return std::sqrt(fastest);
}

/// Moves `thing` by n sub-steps, doubled until the error over h [s] is small enough; returns the error where it is not even
/// then [1/s].
template <class Thing, class Move, class Difference>
double move_by_trial(Thing& thing, Thing& start, Thing& other, SubSteps& n, double h, double accuracy, double gain,
                     Move move, Difference differ) {
  if (n.quiet >= patience) n = halved(n);
  const auto passed = static_cast<std::uint16_t>(n.wait - n.left);
  n.wait = std::min<std::uint16_t>(longest_wait, static_cast<std::uint16_t>(2 * n.wait));
  start = thing;
  move(thing, n.count);
  for (;;) {
    other = start;
    move(other, 2u * n.count);
    const double rate = gain / (gain - 1.0) * differ(thing, other) / h;
    if (rate > accuracy && n.count < sub_step_limit) {
      n = {static_cast<std::uint16_t>(2 * n.count)};
      std::swap(thing, other);
      continue;
    }
    n.quiet = is_quiet(n, rate, accuracy, gain) ? static_cast<std::uint16_t>(n.quiet + passed) : std::uint16_t{0};
    n.left = n.wait;
    return rate > accuracy ? rate : 0.0;
  }
}

/// The error [1/s] that what moves as it wants has between the moments at which it is asked, if it is too large: how much
/// the finest of these still changes.
template <class Move>
double bend_error(const Articulate& a, Trial& trial, const SubStepSettings& wanted, double h, Move move) {
  const auto bent = [](const Condition& c) { return c.bent != Bent::nothing; };
  if (std::none_of(a.conditions.begin(), a.conditions.end(), bent)) return 0.0;
  trial.other = trial.start;
  for (Condition& c : trial.other.conditions) c.bend.curve = zero3();
  move(trial.other, a.sub_steps.count);
  const double rate = difference(a, trial.other) / h;
  return rate > wanted.accuracy ? rate : 0.0;
}

}  // namespace

void drift_accurately(Articulate& a, const DriftSettings& settings, const SubStepSettings& wanted, Trial& trial) {
  const auto move = [&](Articulate& x, std::uint32_t count) {
    x.sub_steps.count = static_cast<std::uint16_t>(count);
    begin_report(x);
    drift(x, settings, x.report);
  };
  const double h = settings.h * (settings.to - settings.from);
  if (a.edited) a.sub_steps = {a.sub_steps.count};
  if (a.safe) return move(a, 1);  // what it cannot do it cannot do better by parts
  if (!is_due(a.sub_steps, wanted, fastest_spin(a) * h / a.sub_steps.count)) return move(a, a.sub_steps.count);
  SubSteps n = a.sub_steps;
  const double unreached =
      move_by_trial(a, trial.start, trial.other, n, h, wanted.accuracy, second_order, move, difference);
  a.sub_steps = n;
  a.report.unreached = std::max(unreached, bend_error(a, trial, wanted, h, move));
}

double drift_alone_accurately(Node& node, double h, const SubStepSettings& wanted, SubSteps& n) {
  const auto move = [&](Node& x, std::uint32_t count) {
    for (std::uint32_t i = 0; i < count; i++) drift_alone(x, h / count);
  };
  if (!node.turns || !is_due(n, wanted, norm(node.O0) * h / n.count)) {
    move(node, n.count);
    return 0.0;
  }
  // Longer turns are cut into the same parts by one sub-step and by two, which would differ by nothing.
  while (norm(node.O0) * h / n.count > whole_turn && n.count < sub_step_limit)
    n = {static_cast<std::uint16_t>(2 * n.count)};
  if (norm(node.O0) * h / n.count > whole_turn) {
    move(node, n.count);
    return 1.0 / h;
  }
  Node start, other;
  const double gain = norm2(node.torque) > 0.0 ? second_order : fourth_order;
  return move_by_trial(node, start, other, n, h, wanted.accuracy, gain, move,
                       [](const Node& a, const Node& b) { return turn_between(a.R0, b.R0); });
}

bool adapt(SubSteps& n, double rate, double accuracy) {
  if (rate > accuracy) {
    while (rate > accuracy && n.count < sub_step_limit) {
      n.count = static_cast<std::uint16_t>(2 * n.count);
      rate /= second_order;
    }
    n.quiet = 0;
    return !(rate > accuracy);
  }
  n.quiet = is_quiet(n, rate, accuracy, second_order) ? static_cast<std::uint16_t>(n.quiet + 1) : std::uint16_t{0};
  if (n.quiet >= patience) n = halved(n);
  return true;
}

}  // namespace pantin
