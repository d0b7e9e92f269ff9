// Targets and violations of constraints at the end of the coming step.
#include "base/functions.hpp"
#include "choreography/hands.hpp"
#include "constraints/kind.hpp"
#include "edit/common.hpp"
#include "forces/sleep.hpp"

namespace pantin {

using namespace internal;

namespace {

double size(Vec3 v) { return norm(v); }
double size(double x) { return std::fabs(x); }

/// Critically damped approach to 0 in a time of h (Barzel and Barr 1988): D(t) = (D0 + (D0' + D0/τ) t) exp(-t/τ), until
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
  if (!c.progress) return 1e-14 * std::fmax(size_of(world, c.a), largest(c.position));
  const double size = std::fmax(size_of(world, c.a), size_of(world, c.b));
  return 0.1 * world.settings.tolerance * (size > 0.0 ? size : largest(position(world, c.a)));
}

void draw_in(const World& world, Constraint& c, double h) {
  c.previous_away = c.away;
  c.previous_excess = c.excess;
  const bool there = size(c.away) == 0.0 && size(c.away_rate) == 0.0 && c.excess == 0.0 && c.excess_rate == 0.0;
  if (there) return;
  const double least = least_violation(world, c);
  approach(c.away, c.away_rate, h, c.time_constant, least);
  approach(c.excess, c.excess_rate, h, c.time_constant, least);
}

/// Of something known at the end of this step and the two before it, h apart [s]: its rate at the end.
template <class Value>
Value rate_at_end(Value now, Value last, Value before, double h, std::uint32_t moves) {
  if (!(h > 0.0)) return Value{};
  return moves >= 2 ? (3.0 * now - 4.0 * last + before) / (2.0 * h) : (now - last) / h;
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
    Vec3 position = c.hand >= 0 ? world.hands[static_cast<std::size_t>(c.hand)].position : c.position;
    if (c.target) position = c.target(t);
    if (!finite(position)) require_finite(describe(world, id), "target", position, "m");
    return world.plane.beside(position, c.position);
  };
  const Vec3 next = target(time);
  c.bend = {};
  if (c.target)
    c.bend = bend_of(world, c,
                     [&](double s) { return target(time + (s - 1.0) * h) - c.position - (next - c.position) * s; });
  c.before = c.previous;
  c.previous = c.position;
  c.position = next;
  c.moves++;
  c.velocity = c.bend.straight() ? rate_at_end(c.position, c.previous, c.before, h, c.moves)
                                 : (c.position - c.previous + c.bend.rate(1.0)) / h;
}

void move_length(const World& world, ConstraintId id, Constraint& c, double time, double h) {
  const auto target = [&](double t) {
    const double value = c.number ? c.number(t) : c.by_speed ? c.length_rate : c.length;
    if (!can_keep(c, value)) require_kept(describe(world, id), c, value);
    return value;
  };
  const double next = target(time);
  c.bend = {};
  const double last = c.by_speed ? c.length_rate : c.length;
  if (c.number)
    c.bend = bend_of(world, c,
                     [&](double s) { return vec(target(time + (s - 1.0) * h) - last - (next - last) * s, 0.0, 0.0); });
  if (c.by_speed) {
    const double mean = 0.5 * (last + next) + c.bend.at(0.5)[0];
    c.previous_rate = last;
    c.length_rate = next;
    c.previous_length = c.angle;
    c.length = c.angle + 2.0 * functions::atan(0.5 * mean * h);  // what a step makes of a body of that spin
    c.moves++;
    return;
  }
  const double middle = 0.5 * (c.previous_length + c.length);
  c.before_length = c.previous_length;
  c.previous_length = c.length;
  c.length = next;
  c.moves++;
  if (rule_of(c).follow != nullptr) rule_of(c).follow(world, c, middle);
  c.length_rate = c.bend.straight() ? rate_at_end(c.length, c.previous_length, c.before_length, h, c.moves)
                                    : (c.length - c.previous_length + c.bend.rate(1.0)[0]) / h;
}

/// The vector of the turn from one orientation to another that is near, [rad] to second order.
Vec3 turn_to(const Quat& to, const Quat& from) {
  const Quat q = to * conjugate(from);
  return vec(q.x, q.y, q.z) * (q.w < 0.0 ? -2.0 : 2.0);
}

void move_attitude(const World& world, ConstraintId id, Constraint& c, double time, double h) {
  const auto target = [&](double t) {
    return turned_in_plane(world, c.body_a, unit(describe(world, id), c.attitude(t)));
  };
  const Quat next = target(time);
  c.bend = bend_of(world, c, [&](double s) {
    const Quat straight = between(c.turn, next, s), q = target(time + (s - 1.0) * h) * conjugate(straight);
    return direction(vec(q.x, q.y, q.z)) * (2.0 * functions::atan2(norm(vec(q.x, q.y, q.z)), q.w));
  });
  c.previous_turn = c.turn;
  c.turn = next;
  const Vec3 mean = turn_to(c.turn, c.previous_turn) / h;
  c.moves++;
  c.spin = c.moves >= 2 ? mean * 1.5 - c.previous_spin * 0.5 : mean;
  if (!c.bend.straight()) c.spin = mean + c.bend.rate(1.0) / h;
  c.previous_spin = mean;
}

/// Whether what it keeps is at the end of this step other than at its start, or was in the last.
bool moves(const Constraint& c) {
  const auto differ = [](Vec3 a, Vec3 b) { return norm2(a - b) > 0.0; };
  const Quat p = c.turn, q = c.previous_turn;
  return (c.kind == ConstraintKind::follow && (differ(c.position, c.previous) || norm2(c.velocity) > 0.0)) ||
         ((c.number || c.by_speed) && (c.length != c.previous_length || c.length_rate != 0.0)) ||
         (c.attitude && (p.w != q.w || p.x != q.x || p.y != q.y || p.z != q.z || norm2(c.spin) > 0.0)) ||
         norm2(c.away) + norm2(c.previous_away) + norm2(c.away_rate) > 0.0 || c.excess != 0.0 ||
         c.previous_excess != 0.0 || c.excess_rate != 0.0;
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
    if (c.kind == ConstraintKind::follow) move_position(world, id, c, time, h);
    if (c.number || c.by_speed) move_length(world, id, c, time, h);
    if (c.attitude) move_attitude(world, id, c, time, h);
    draw_in(world, c, h);
    if (moves(c)) wake(world, c);
  }
}

}  // namespace pantin
