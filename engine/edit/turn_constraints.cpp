// Constraints that tie rotations: weld, orient, align, motor, limit of an angle, and the axis of a hinge.
#include <algorithm>
#include <utility>

#include "constraints/kind.hpp"
#include "edit/common.hpp"
#include "edit/constrain.hpp"
#include "forces/sleep.hpp"

namespace pantin {

using namespace internal;

namespace {

/// As the two are now.
Constraint tie_of(const World& world, ConstraintKind kind, BodyId a, BodyId b) {
  Constraint c;
  c.kind = kind;
  c.body_a = a;
  c.body_b = b;
  c.turn.now = orientation(world, a);
  if (b) c.turn.now = normalised(conjugate(orientation(world, b)) * c.turn.now);
  c.turn.previous = c.turn.now;
  return c;
}

/// The same of what was given.
Constraint tie_of_given(const World& world, ConstraintKind kind, BodyId a, BodyId b) {
  require_turning(world, kind_name(kind), a);
  if (b) require_turning(world, kind_name(kind), b);
  return tie_of(world, kind, a, b);
}

void set_axis(const World& world, Constraint& c, Vec3 axis) {
  c.axis_a = in_frame(world, c.body_a, axis);
  c.axis_b = in_frame(world, c.body_b, axis);
}

}  // namespace

ConstraintId add_weld(World& world, BodyId a, BodyId b) {
  for (BodyId body : {a, b}) require(world.bodies.alive(body), "weld: ", world.bodies.story(body));
  Constraint c = tie_of_given(world, ConstraintKind::weld, a, b);
  const Vec3 middle = 0.5 * (world.motion_of(a).x + world.motion_of(b).x);
  c.own = WeldData{in_frame(world, a, middle - origin(world, a)), in_frame(world, b, middle - origin(world, b))};
  return add_constraint(world, std::move(c));
}

ConstraintId add_orient(World& world, BodyId body, const OrientDef& def) {
  require_unlocked(world, "orient");
  Constraint c = tie_of_given(world, ConstraintKind::orient, body, {});
  c.time_constant = def.time_constant;
  if (def.to) c.turn.now = unit("orient", *def.to);
  if (def.target) {
    const Lock lock(world);
    c.turn.now = turned_in_plane(world, body, unit("orient", def.target(world.time)));
  }
  c.turn.of_time = def.target;
  return add_constraint(world, std::move(c));
}

ConstraintId add_align(World& world, BodyId a, BodyId b, const AlignDef& def) {
  Constraint c = tie_of_given(world, ConstraintKind::align, a, b);
  c.time_constant = def.time_constant;
  c.axis_a = unit_vector("align", "the first axis", def.axis_a);
  c.axis_b = unit_vector("align", "the second axis", def.axis_b);
  rule_of(c).set(c, "align", def.angle.value_or(present_value(world, c)));
  return add_constraint(world, std::move(c));
}

ConstraintId add_motor(World& world, BodyId a, BodyId b, const MotorDef& def) {
  Constraint c = tie_of_given(world, ConstraintKind::motor, a, b);
  require(def.speed.has_value() != def.angle.has_value(), "motor: needs either speed [rad/s] or angle [rad]");
  c.time_constant = def.time_constant;
  c.max_torque = def.max_torque;
  set_axis(world, c, unit_vector("motor", "axis", def.axis));
  c.by_speed = def.speed.has_value();
  c.number.of_time = def.number;
  c.number.now = def.angle.value_or(0.0);
  c.number.rate = def.speed.value_or(0.0);
  return add_constraint(world, std::move(c));
}

ConstraintId add_limit(World& world, BodyId a, BodyId b, Vec3 axis, const LimitDef& def) {
  Constraint c = tie_of_given(world, ConstraintKind::limit, a, b);
  c.time_constant = def.time_constant;
  c.low = def.min;
  c.high = def.max;
  set_axis(world, c, unit_vector("limit", "axis", axis));
  return add_constraint(world, std::move(c));
}

void set_length(World& world, ConstraintId id, double value, std::function<double(double)> function) {
  require_unlocked(world, "a number to keep");
  Constraint& c = world.constraints[id];
  require(rule_of(c).keeps.name != nullptr, "a number to keep: ", describe(world, id), " has none");
  wake(world, c);
  const std::string who = describe(world, id);
  require_kept(who, c, value);
  const bool pays_out =
      c.kind == ConstraintKind::string && value > c.number.now && !function && !c.number.of_time && !is_drawn_in(c);
  const double from = is_paid_out(c) ? c.number.now : c.number.previous;
  c.number.of_time = std::move(function);
  if (c.by_speed) {
    c.number.rate = value;
    c.moves = 0;
    return;
  }
  if (rule_of(c).set != nullptr) {
    rule_of(c).set(c, who, value);
    mark_edited(world, c);
  } else {
    c.number.now = value;
  }
  start_constraint(world, c);
  if (pays_out) c.number.previous = from;
}

void set_attitude(World& world, ConstraintId id, const Quat& to, std::function<Quat(double)> target) {
  Constraint& c = of_kinds(world, id, {ConstraintKind::orient}, "an orientation to keep");
  const Quat turn = unit(describe(world, id), to);
  if (!target) require_turn(world, describe(world, id), c.body_a, turn);
  c.turn.now = turned_in_plane(world, c.body_a, turn);
  c.turn.of_time = std::move(target);
  start_constraint(world, c);
}

void set_range(World& world, ConstraintId id, double min, double max) {
  Constraint& c = of_kinds(world, id, {ConstraintKind::limit}, "a range");
  require_range("limit", min, max, c.a ? "m" : "rad");
  if (c.a) require_not_negative("limit", "min", min, "m");
  c.low = min;
  c.high = max;
  start_constraint(world, c);
}

void set_max_torque(World& world, ConstraintId id, double torque) {
  Constraint& c = of_kinds(world, id, {ConstraintKind::motor}, "max_torque");
  require_positive_or_infinite("motor", "max_torque", torque, "N m");
  c.max_torque = torque;
}

namespace internal {

namespace {

/// In a ring that does not hold now its axis does not either.
void insert_axis(World& world, ParticleId hinge, std::uint64_t given, Constraint c) {
  c.own = AxisData{hinge, given};
  c.enabled = world.particles[hinge].enabled;
  const ConstraintId id = insert_constraint(world, std::move(c));
  world.particles[hinge].axes.push_back(id);
}

}  // namespace

void add_axes(World& world, ParticleId hinge, std::span<const BodyId> bodies, Vec3 axis) {
  if (world.plane.flat()) return;  // nothing turns about another
  for (std::size_t i = 1; i < bodies.size(); i++) {
    Constraint c = tie_of(world, ConstraintKind::axis, bodies[0], bodies[i]);
    set_axis(world, c, direction(axis));
    insert_axis(world, hinge, world.particles[hinge].serial, std::move(c));
  }
}

void take_over_axes(World& world, ParticleId from, ParticleId to) {
  for (ConstraintId id : std::exchange(world.particles[from].axes, {})) {
    world.constraints[id].as<AxisData>().ring = to;
    world.particles[to].axes.push_back(id);
    set_enabled(world, id, world.particles[to].enabled);
  }
}

void require_axis(const World& world, std::span<const BodyId> bodies, Vec3 axis) {
  require_about_normal(world, "hinge", "axis", unit_vector("hinge", "axis", axis), "");
  require(bodies.size() >= 2, "hinge: axis needs two bodies; a free particle has no orientation");
  for (BodyId body : bodies) require_turning(world, "hinge", body);
}

void drop_axes(World& world, ParticleId hinge, BodyId body) {
  const std::vector<ConstraintId> axes = world.particles[hinge].axes;
  std::vector<Constraint> left;  // without their first body the others of the same call are tied to the next
  for (ConstraintId id : axes) {
    const Constraint& c = world.constraints[id];
    if (body && c.body_a != body && c.body_b != body) continue;
    if (body && c.body_a == body) left.push_back(c);
    take_out_constraint(world, id, {describe(world, id), world.time, culprit(world)});
  }
  for (const Constraint& other : left) {
    const Constraint& next = *std::find_if(left.begin(), left.end(), [&](const Constraint& c) {
      return c.as<AxisData>().given == other.as<AxisData>().given;
    });
    if (&next == &other) continue;
    Constraint c = tie_of(world, ConstraintKind::axis, next.body_b, other.body_b);
    c.axis_a = next.axis_b;
    c.axis_b = other.axis_b;
    insert_axis(world, hinge, other.as<AxisData>().given, std::move(c));
  }
}

}  // namespace internal

}  // namespace pantin
