#include "articulates/solve/sub_steps.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "articulates/solve/drift.hpp"
#include "articulates/solve/loose.hpp"
#include "articulates/solve/state.hpp"

namespace pantin {

namespace {

constexpr std::uint16_t long_quiet = 64;  // steps after which half as many sub-steps are tried
constexpr std::uint16_t longest_wait = 64;
constexpr double turn_at_once = 1.0;  // [rad] that a body without rows turns by at once
constexpr double faster = 1.1;        // than at the last trial: then there is another

constexpr double second_order = 4.0, fourth_order = 16.0;  // the error falls by this much with twice as many sub-steps

/// An error so small counts as quiet: half as many sub-steps have `error_ratio` times as much, and need some room.
bool is_quiet(const SubSteps& n, double rate, double accuracy, double error_ratio) {
  return n.count > 1 && 2.0 * error_ratio * rate <= accuracy;
}

/// Whether a trial is due by time. Where a number has been quiet for long, half of it is tried.
bool is_due(SubSteps& n, const SubStepSettings& wanted) {
  if (!wanted.may_try) return false;
  if (n.left > 0) n.left--;
  if (n.left > 0) return false;
  if (n.quiet >= long_quiet) n = {static_cast<std::uint16_t>(n.count / 2), 0, 1, 0, n.turn};
  return true;
}

/// Angle between two orientations, if small [rad].
double turn_between(const Mat3& a, const Mat3& b) {
  return std::sqrt(0.5 * (norm2(a[0] - b[0]) + norm2(a[1] - b[1]) + norm2(a[2] - b[2])));
}

/// Largest distance of a point of the body between its two ends [m].
double distance(const Node& a, const Node& b) {
  const double moved = norm(a.x0 - b.x0);
  return a.turns ? moved + extent(a) * turn_between(a.R0, b.R0) : moved;
}

/// Whether it was halved: its parts may be the other's sub-steps, and the difference 0.
bool is_halved(const DriftReport& report) { return report.halved > 0 && report.fallbacks == 0; }

double difference(const Articulate& a, const Articulate& b) {
  if (is_halved(a.report) || is_halved(b.report)) return infinity;
  double worst = 0.0;
  for (std::size_t i = 0; i < a.nodes.size(); i++) worst = std::max(worst, distance(a.nodes[i], b.nodes[i]));
  return worst / a.length;
}

/// Fills in `means` after a move from `start` over h [s]; returns the largest jerk that they tell [m/s³].
double find_means(const Articulate& a, const Articulate& start, double h, double span, std::vector<MeanMotion>& means) {
  means.resize(a.nodes.size());
  const double between = 0.5 * (span + a.means_span);
  double worst = 0.0;
  for (std::size_t i = 0; i < means.size(); i++) {
    const Node &from = start.nodes[i], &to = a.nodes[i];
    const double arm = extent(to);
    for (std::size_t k = 0; k < 2; k++) {
      const int axis = static_cast<int>(k);
      Vec3& velocity = means[i].velocity[k];
      velocity = (to.x0 - from.x0 + (to.R0[axis] - from.R0[axis]) * arm) / h;
      if (a.means_known == 0) continue;
      Vec3& acceleration = means[i].acceleration[k];
      acceleration = (velocity - a.means[i].velocity[k]) / between;
      if (a.means_known > 1) worst = std::max(worst, norm2(acceleration - a.means[i].acceleration[k]));
    }
  }
  return std::sqrt(worst) / between;
}

void keep_means(Articulate& a, std::vector<MeanMotion>& means, double span) {
  a.means.swap(means);
  a.means_span = span;
  a.means_known = std::min<std::uint8_t>(2, static_cast<std::uint8_t>(a.means_known + 1));
}

/// The error of sub-steps by h² |jerk|, after a trial; that of trials before is forgotten slowly.
float error_by_jerk(float before, double rate, double by_jerk) {
  constexpr double most = 1.0, least = 1e-4, remembered = 0.7;
  const double now = rate < most * by_jerk ? rate / by_jerk : most;
  return static_cast<float>(std::max({now, remembered * static_cast<double>(before), least}));
}

/// How a trial ended: the last error over h [s] [1/s], and whether it is small enough.
struct Tried {
  double rate = 0.0;
  bool reached = true;
};

/// After a `thing` was moved from `start` by n sub-steps: doubles them until the error over h [s] is small enough. With twice as
/// many it falls `error_ratio` times.
template <class Thing, class Move, class Difference>
Tried double_sub_steps(Thing& thing, const Thing& start, Thing& other, SubSteps& n, double h, double accuracy,
                       double error_ratio, Move move, Difference differ) {
  const auto passed = static_cast<std::uint16_t>(n.wait - n.left);
  n.wait = std::min<std::uint16_t>(longest_wait, static_cast<std::uint16_t>(2 * n.wait));
  for (;;) {
    other = start;
    move(other, 2u * n.count);
    const double rate = error_ratio / (error_ratio - 1.0) * differ(thing, other) / std::fabs(h);
    if (rate > accuracy && n.count < sub_step_limit) {
      n = {static_cast<std::uint16_t>(2 * n.count), 0, 1, 0, n.turn};
      std::swap(thing, other);
      continue;
    }
    n.quiet =
        is_quiet(n, rate, accuracy, error_ratio) ? static_cast<std::uint16_t>(n.quiet + passed) : std::uint16_t{0};
    n.left = n.wait;
    return {rate, !(rate > accuracy)};
  }
}

/// The error [1/s] that what moves as it wants has between the moments at which it is asked: what it is seen to be off there,
/// of which what is tied to it keeps a part, since it is right again at the next of them.
double error_between(const Articulate& a, double h) {
  constexpr double passed_on = 0.125;  // of an anchor that begins to move at once; it was 0.04 at most
  double worst = 0.0;
  for (const Condition& c : a.conditions)
    if (c.bent != Bent::nothing) worst = std::max(worst, c.bend.missed * (c.by_speed ? std::fabs(h) : 1.0));
  return passed_on * worst / (a.length * std::fabs(h));
}

/// What the finest moments at which such motion is asked still change, if that is too large, else 0 [1/s]: the stage is done once
/// more with the bend of the straight way without its term of fourth order.
template <class Move>
double bend_error(const Articulate& a, Trial& trial, const SubStepSettings& wanted, double h, std::uint32_t count,
                  Move move) {
  const auto bent = [](const Condition& c) { return c.bent != Bent::nothing; };
  if (std::none_of(a.conditions.begin(), a.conditions.end(), bent)) return 0.0;
  trial.other = trial.start;
  for (Condition& c : trial.other.conditions) c.bend.curve = zero3();
  move(trial.other, count);
  const double rate = difference(a, trial.other) / std::fabs(h);
  return rate > wanted.accuracy ? rate : 0.0;
}

}  // namespace

void drift_accurately(Articulate& a, const DriftSettings& settings, const SubStepSettings& wanted, Trial& trial) {
  const auto move = [&](Articulate& x, std::uint32_t count) {
    x.sub_steps.count = static_cast<std::uint16_t>(count);
    begin_report(x);
    drift_midpoint(x, settings, x.report);
  };
  const double h = settings.step * (settings.to - settings.from);
  if (a.edited) {
    a.sub_steps = {a.sub_steps.count};
    a.error_by_jerk = 0.0F;
  }
  if (a.edited || a.fell_back) a.means_known = 0;
  if (a.fell_back) return move(a, 1);  // what it cannot do it cannot do better by parts
  SubSteps n = a.sub_steps;
  bool due = is_due(n, wanted) || (wanted.span != 0.0 && a.means_known < 2);
  trial.start = a;
  move(a, n.count);
  double jerk = 0.0;
  if (wanted.span != 0.0) jerk = find_means(a, trial.start, h, wanted.span, trial.means);
  const auto by_jerk = [&] { return h * h / (1.0 * n.count * n.count) * jerk / a.length; };
  due = due || is_halved(a.report) || static_cast<double>(a.error_by_jerk) * by_jerk() > wanted.accuracy;
  if (due) {
    const Tried tried =
        double_sub_steps(a, trial.start, trial.other, n, h, wanted.accuracy, second_order, move, difference);
    a.error_by_jerk = error_by_jerk(a.error_by_jerk, tried.rate, by_jerk());
    a.report.unreached = std::max(tried.reached ? 0.0 : tried.rate, bend_error(a, trial, wanted, h, n.count, move));
    if (wanted.span != 0.0) find_means(a, trial.start, h, wanted.span, trial.means);
  }
  if (wanted.may_try)
    if (const double between = error_between(a, settings.step); between > wanted.accuracy)
      a.report.unreached = std::max(a.report.unreached, between);
  a.sub_steps = n;
  if (wanted.span != 0.0) keep_means(a, trial.means, wanted.span);
}

double drift_alone_accurately(Node& node, double h, const SubStepSettings& wanted, SubSteps& n) {
  const auto move = [&](Node& x, std::uint32_t count) {
    for (std::uint32_t i = 0; i < count; i++) drift_alone(x, h / count);
  };
  const auto turn = [&] { return norm(node.spin0) * std::fabs(h) / n.count; };
  if (!node.turns || wanted.accuracy == 0.0) {
    move(node, n.count);
    return 0.0;
  }
  if (!is_due(n, wanted) && turn() <= faster * static_cast<double>(n.turn)) {
    move(node, n.count);
    return 0.0;
  }
  // Longer turns are cut into the same parts by one sub-step and by two, which would differ by nothing.
  while (turn() > turn_at_once && n.count < sub_step_limit) n = {static_cast<std::uint16_t>(2 * n.count)};
  if (turn() > turn_at_once) {
    move(node, n.count);
    return 1.0 / std::fabs(h);
  }
  const double error_ratio = norm2(node.torque) > 0.0 ? second_order : fourth_order;
  Node start = node, other;
  move(node, n.count);
  const Tried tried = double_sub_steps(node, start, other, n, h, wanted.accuracy, error_ratio, move,
                                       [](const Node& a, const Node& b) { return turn_between(a.R0, b.R0); });
  n.turn = static_cast<float>(norm(start.spin0) * std::fabs(h) / n.count);
  return tried.reached ? 0.0 : tried.rate;
}

bool adapt(SubSteps& n, double rate, double accuracy) {
  if (rate > accuracy) {
    while (rate > accuracy && n.count < sub_step_limit) {
      const auto count = static_cast<std::uint16_t>(std::min(2 * n.count, int{sub_step_limit}));
      const double finer = static_cast<double>(count) / n.count;
      n.count = count;
      rate /= finer * finer;
    }
    n.quiet = 0;
    return !(rate > accuracy);
  }
  n.quiet = is_quiet(n, rate, accuracy, second_order) ? static_cast<std::uint16_t>(n.quiet + 1) : std::uint16_t{0};
  if (n.quiet >= long_quiet) n = {static_cast<std::uint16_t>(n.count / 2)};
  return true;
}

}  // namespace pantin
