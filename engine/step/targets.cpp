// Targets and violations of constraints at the end of the coming step.
#include <algorithm>
#include <utility>

#include "base/functions.hpp"
#include "base/rotation.hpp"
#include "choreography/hands.hpp"
#include "constraints/geometry.hpp"
#include "constraints/kind.hpp"
#include "edit/common.hpp"
#include "forces/sleep.hpp"

namespace pantin {

using namespace internal;

namespace {

double size(Vec3 v) { return norm(v); }
double size(double x) { return std::fabs(x); }

/// Critically damped approach to 0 in a time of h (Barzel and Barr 1988): σ(t) = (σ0 + (σ̇0 + σ0/τ) t) exp(-t/τ), until
/// `least` is left [m].
template <class Violation>
void approach(Violation& away, Violation& rate, double h, double tau, double least) {
  if (size(away) == 0.0 && size(rate) == 0.0) return;
  const Violation slope = rate + away / tau;
  const double decay = functions::exp(-h / tau);
  away = (away + slope * h) * decay;
  rate = (rate - slope * (h / tau)) * decay;
  if (size(away) <= least && size(rate) * tau <= least) away = rate = Violation{};
}

/// What is left of a violation when it counts as none, [m]. Points that are to be joined need not come nearer for ever.
double least_violation(const World& world, const Constraint& c) {
  if (!c.a) return 1e-14;
  const double own = size_of(world, c.a);
  const double size =
      c.progress() ? std::fmax(own, size_of(world, c.b)) : std::max({own, largest(c.position.now), size_of(c)});
  return (c.progress() ? 0.1 * world.settings.tolerance : 1e-14) * (size > 0.0 ? size : largest(position(world, c.a)));
}

/// Whether it has an angle about an axis, with all its turns.
bool counts_turns(const Constraint& c) {
  return c.kind == ConstraintKind::motor || (c.kind == ConstraintKind::limit && !c.a);
}

/// A motor of an angle whose torque did not take it where it was to be goes on from where it is, in a step of h [s].
void go_on_from_here(const World& world, Constraint& c, double h) {
  constexpr double there = 1e-9;  // [rad]
  if (c.kind != ConstraintKind::motor || c.by_speed || std::isinf(c.max_torque)) return;
  const double start = c.number.of_time ? c.number.previous : c.number.now, off = c.angle - start;
  if (std::fabs(off - c.attract.excess) <= there) return;
  c.attract.excess = off;
  c.attract.excess_rate =
      dot(direction_of(world, c.body_a, c.axis_a), relative_spin(world, c)) - (c.number.now - start) / h;
}

void draw_in(const World& world, Constraint& c, double h) {
  c.attract.previous_away = c.attract.away;
  c.attract.previous_excess = c.attract.excess;
  const bool there = size(c.attract.away) == 0.0 && size(c.attract.away_rate) == 0.0 && c.attract.excess == 0.0 &&
                     c.attract.excess_rate == 0.0;
  if (there) return;
  const double least = least_violation(world, c);
  approach(c.attract.away, c.attract.away_rate, h, c.time_constant, least);
  approach(c.attract.excess, c.attract.excess_rate, h, c.time_constant, least);
}

double product(double x, double y) { return x * y; }
double product(Vec3 x, Vec3 y) { return dot(x, y); }

/// The rate at the end of a step of what is known at the ends of steps, by its mean rates in them: they go on to change as in the
/// last step, as far as they did so in the two before as well. At a kink, which may part a step, they do not.
template <class Value>
Value rate_at_end(Value mean, Value last_mean, Value& change, Value& earlier_change, std::uint32_t moves) {
  if (moves < 2) return mean;
  const Value earliest = std::exchange(earlier_change, change), earlier = std::exchange(change, mean - last_mean);
  const double square = product(change, change);
  double part = 0.5;
  const auto as_before = [&](Value before) {
    part = std::min(part, 0.5 * std::max(0.0, product(before, change) / square));
  };
  if (moves > 2 && square > 0.0) as_before(earlier);
  if (moves > 3 && square > 0.0) as_before(earliest);
  return mean + change * part;
}

/// The same of positions or numbers, moved on by now.
template <class Value, class Rate>
Rate rate_at_end(Prescribed<Value, Rate>& of, double h, std::uint32_t moves) {
  if (!(h > 0.0)) return Rate{};
  return rate_at_end<Rate>((of.now - of.previous) / h, (of.previous - of.before) / h, of.change, of.earlier_change,
                           moves);
}

/// Whether steps are divided finely enough to tell the way between their ends from a straight one.
bool follows_bends(const World& world) {
  return world.settings.accuracy || world.settings.integrator == Integrator::suzuki4;
}

/// The way of what moves as it wants, by what that is `off` the straight one at stages of the step. None of one that does not
/// begin where the last step ended.
template <class Off>
Bend bend_of(const World& world, const Constraint& c, Off off) {
  if (!follows_bends(world)) return {};
  const Vec3 quarter = off(0.25), half = off(0.5), three_quarters = off(0.75);
  const bool jumps = c.moves == 0 && norm(off(0.0)) > std::fmax(norm(quarter), norm(half));
  if (jumps) return {};
  Bend bend = Bend::through(quarter, half, three_quarters);
  for (double s : {0.125, 0.375, 0.625, 0.875}) bend.missed = std::fmax(bend.missed, norm(off(s) - bend.at(s)));
  return bend;
}

void move_position(const World& world, ConstraintId id, Constraint& c, double time, double h) {
  const auto target = [&](double t) {
    Vec3 position = c.hand >= 0 ? world.hands[static_cast<std::size_t>(c.hand)].position : c.position.now;
    if (c.position.of_time) position = c.position.of_time(t);
    if (!finite(position)) require_finite(describe(world, id), "target", position, "m");
    return world.plane.beside(position, c.position.now);
  };
  const Vec3 next = target(time);
  c.bend = {};
  if (c.position.of_time)
    c.bend = bend_of(world, c, [&](double s) {
      return target(time + (s - 1.0) * h) - c.position.now - (next - c.position.now) * s;
    });
  c.position.before = c.position.previous;
  c.position.previous = c.position.now;
  c.position.now = next;
  c.moves++;
  c.position.rate = c.bend.straight() ? rate_at_end(c.position, h, c.moves)
                                      : (c.position.now - c.position.previous + c.bend.rate(1.0)) / h;
}

void move_length(const World& world, ConstraintId id, Constraint& c, double time, double h) {
  const auto target = [&](double t) {
    const double value = c.number.of_time ? c.number.of_time(t) : c.by_speed ? c.number.rate : c.number.now;
    if (!rule_of(c).keeps.allows(value)) require_kept(describe(world, id), c, value);
    return value;
  };
  const double next = target(time);
  c.bend = {};
  const double last = c.by_speed ? c.number.rate : c.number.now;
  if (c.number.of_time)
    c.bend = bend_of(world, c,
                     [&](double s) { return vec(target(time + (s - 1.0) * h) - last - (next - last) * s, 0.0, 0.0); });
  if (c.by_speed) {
    const double mean = 0.5 * (last + next) + c.bend.at(0.5)[0];
    c.number.previous_rate = last;
    c.number.rate = next;
    c.number.previous = c.angle;
    c.number.now = c.angle + 2.0 * functions::atan(0.5 * mean * h);  // what a step makes of a body of that spin
    c.moves++;
    return;
  }
  const double middle = 0.5 * (c.number.previous + c.number.now);
  c.number.before = c.number.previous;
  c.number.previous = c.number.now;
  c.number.now = next;
  c.moves++;
  if (rule_of(c).follow != nullptr) rule_of(c).follow(world, c, middle);
  c.number.rate = c.bend.straight() ? rate_at_end(c.number, h, c.moves)
                                    : (c.number.now - c.number.previous + c.bend.rate(1.0)[0]) / h;
}

/// A string that was written longer becomes so in this step.
void pay_out(Constraint& c, double h) {
  if (is_paid_out(c)) c.number.previous = c.number.now;
  c.number.rate = (c.number.now - c.number.previous) / h;
  c.moves = 1;
}

void move_orientation(const World& world, ConstraintId id, Constraint& c, double time, double h) {
  const auto target = [&](double t) {
    return turned_in_plane(world, c.body_a, unit(describe(world, id), c.turn.of_time(t)));
  };
  const Quat next = target(time);
  c.bend = bend_of(world, c, [&](double s) {
    return rotation_vector(target(time + (s - 1.0) * h) * conjugate(between(c.turn.now, next, s)));
  });
  c.turn.previous = c.turn.now;
  c.turn.now = next;
  const Vec3 mean = rotation_vector(c.turn.now * conjugate(c.turn.previous)) / h;
  c.moves++;
  c.turn.rate = rate_at_end(mean, c.turn.previous_rate, c.turn.change, c.turn.earlier_change, c.moves);
  if (!c.bend.straight()) c.turn.rate = mean + c.bend.rate(1.0) / h;
  c.turn.previous_rate = mean;
}

/// Whether what it keeps is at the end of this step other than at its start, or was in the last.
bool moves(const Constraint& c) {
  const auto differ = [](Vec3 a, Vec3 b) { return norm2(a - b) > 0.0; };
  return (c.kind == ConstraintKind::follow &&
          (differ(c.position.now, c.position.previous) || norm2(c.position.rate) > 0.0)) ||
         ((c.number.of_time || c.by_speed) && (c.number.now != c.number.previous || c.number.rate != 0.0)) ||
         (c.turn.of_time && (!same(c.turn.now, c.turn.previous) || norm2(c.turn.rate) > 0.0)) ||
         norm2(c.attract.away) + norm2(c.attract.previous_away) + norm2(c.attract.away_rate) > 0.0 ||
         c.attract.excess != 0.0 || c.attract.previous_excess != 0.0 || c.attract.excess_rate != 0.0;
}

}  // namespace

void sample_targets(World& world) {
  const Acting acting(world);
  world.locked = true;
  const double time = next_time(world), h = world.settings.step;
  for (std::uint32_t s = 0; s < world.constraints.slots(); s++) {
    if (!world.constraints.alive_at(s)) continue;
    const ConstraintId id = world.constraints.id_at(s);
    Constraint& c = world.constraints.at_slot(s);
    if (c.enabled && counts_turns(c)) count_anew(world, c);
    if (c.kind == ConstraintKind::follow) move_position(world, id, c, time, h);
    if (c.number.of_time || c.by_speed) move_length(world, id, c, time, h);
    if (c.kind == ConstraintKind::string && !c.number.of_time) pay_out(c, h);
    if (c.turn.of_time) move_orientation(world, id, c, time, h);
    go_on_from_here(world, c, h);
    draw_in(world, c, h);
    if (moves(c)) wake(world, c);
  }
}

}  // namespace pantin
