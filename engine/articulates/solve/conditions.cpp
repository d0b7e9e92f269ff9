#include "articulates/solve/conditions.hpp"

#include <algorithm>

#include "articulates/solve/matrix.hpp"
#include "base/functions.hpp"
#include "base/rotation.hpp"
#include "constraints/row_rule.hpp"

namespace pantin {

double inertia_about(const Articulate& a, Vec3 position) {
  double sum = 0.0;
  for (const Node& n : a.nodes) sum += n.mass * norm2(n.x0 - position) + largest(n.inertia);
  return sum;
}

namespace {

double displacement_of(const Condition& c) { return c.whole_value1 - c.whole_value0; }

}  // namespace

bool stall_motors(Articulate& a, double step) {
  const bool limits =
      std::any_of(a.conditions.begin(), a.conditions.end(), [](const Condition& c) { return c.ranged; });
  bool stalled = false;
  for (Condition& c : a.conditions) {
    const Row& r = row(a, c);
    const double displacement = std::fabs(displacement_of(c));
    const bool yields = limits || std::isfinite(c.upper);
    if (!is_motor(r, c) || !yields || std::isfinite(c.stall_force) || displacement == 0.0) continue;
    const double inertia = inertia_about(a, a.nodes[static_cast<std::size_t>(r.a)].x0) / (r.lever * r.lever);
    c.stall_force = std::fmin(c.upper, 2.0 * norm(r.f) + 0.01 * inertia * displacement / (step * step));
    c.yields_by = displacement / c.stall_force;
    stalled = true;
  }
  return stalled;
}

void strengthen_stalled(Articulate& a, double step) {
  constexpr double most_needed = 1e4;  // more would leave few digits to what else there is
  for (Condition& c : a.conditions) {
    if (std::isinf(c.stall_force) || std::isinf(c.upper)) continue;
    const double displacement = std::fabs(displacement_of(c)),
                 enough = most_needed * displacement / (step * step * mobility(a, row(a, c)));
    const double more = std::fmin(std::fmin(10.0 * c.stall_force, c.upper), enough);
    if (!(more > c.stall_force)) continue;
    c.stall_force = more;
    c.yields_by = displacement / more;
  }
}

bool is_turned(const Condition& c) { return !same(c.whole_turn0, c.whole_turn1); }

Vec3 turn_in_step(const Condition& c) { return rotation_vector(c.whole_turn1 * conjugate(c.whole_turn0)); }

namespace {

/// How far what is prescribed is off the straight way between the ends of the step, over s (1 - s) at the part s of it: its rate
/// changes evenly from what it must have been at the start, by its mean, to what it is at the end. Where it is bent otherwise, or a
/// speed, none.
struct Bow {
  Vec3 position = zero3(), turn = zero3();  // [m], [rad]
  double value = 0.0;
};

Bow bow_of(const Condition& c, double lever, double step) {
  if (c.bent != Bent::nothing || c.by_speed) return {};
  Bow bow;
  bow.value = displacement_of(c) - c.value_rate * step;
  if (lever == 0.0)
    bow.position = c.whole1 - c.whole0 - c.velocity * step;
  else if (is_turned(c))
    bow.turn = turn_in_step(c) - c.velocity * (step / lever);
  return bow;
}

}  // namespace

double speed(const Condition& c, double at) {
  return c.start_rate + (c.value_rate - c.start_rate) * at + c.bend.at(at)[0];
}

void set_conditions(Articulate& a, double step, double from, double to) {
  const double off_from = from * (1.0 - from), off_to = to * (1.0 - to);
  for (Condition& c : a.conditions) {
    const Row& r = row(a, c);
    const Bow bow = off_from == 0.0 && off_to == 0.0 ? Bow{} : bow_of(c, r.lever, step);
    const Vec3 displacement = c.whole1 - c.whole0;
    c.position0 = c.whole0 + displacement * from + bow.position * off_from;
    c.position1 = to == 1.0 ? c.whole1 : c.whole0 + displacement * to + bow.position * off_to;
    c.kept_value = to == 1.0 ? c.whole_value1 : c.whole_value0 + displacement_of(c) * to + bow.value * off_to;
    if (c.bent == Bent::position) {
      c.position0 += c.bend.at(from);
      c.position1 += c.bend.at(to);
    }
    if (c.bent == Bent::value && !c.by_speed) c.kept_value += c.bend.at(to)[0];
    if (r.lever == 0.0) continue;
    if (c.by_speed)
      c.kept_value =
          r.lever *
          (c.angle0 + 2.0 * functions::atan(0.5 * step * (to - from) * speed(c, 0.5 * (from + to)) / r.lever));
    c.turn0 = between(c.whole_turn0, c.whole_turn1, from);
    c.turn1 = between(c.whole_turn0, c.whole_turn1, to);
    if (norm2(bow.turn) > 0.0) {
      c.turn0 = quaternion_of(bow.turn * off_from) * c.turn0;
      c.turn1 = quaternion_of(bow.turn * off_to) * c.turn1;
    }
    if (c.bent == Bent::turn) {
      c.turn0 = quaternion_of(c.bend.at(from)) * c.turn0;
      c.turn1 = quaternion_of(c.bend.at(to)) * c.turn1;
    }
    if (norm2(c.whole0) + norm2(c.whole1) == 0.0) continue;  // no axis is drawn in
    c.axis0 = rotate(quaternion_of(c.position0), c.axis);
    c.axis1 = rotate(quaternion_of(c.position1), c.axis);
  }
}

}  // namespace pantin
