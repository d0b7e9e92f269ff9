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

void require_turning(const World& world, const char* call, BodyId body) {
  require(world.bodies.alive(body), call, ": ", world.bodies.story(body));
  require(world.motion_of(body).freedom != Freedom::point, call, ": ", describe(world, body),
          " has all its mass at one position, so it has no orientation; give it an inertia");
}

void require_two(const World& world, const char* call, BodyId a, BodyId b) {
  require_turning(world, call, a);
  if (!b) return;
  require_turning(world, call, b);
  require(a != b, call, ": both are ", describe(world, a), "; it needs two bodies");
}

/// An axis at unit length; throws Error where it has none.
Vec3 unit_axis(const char* call, const char* name, Vec3 axis) {
  require_finite(call, name, axis, "");
  require(norm(axis) > 0.0, call, ": ", name, " must not be vec(0, 0, 0)");
  return axis / norm(axis);
}

Vec3 in_frame(const World& world, BodyId body, Vec3 v) {
  return body ? rotate(conjugate(orientation(world, body)), v) : v;
}

Constraint tie_of(const World& world, ConstraintKind kind, BodyId a, BodyId b) {
  Constraint c;
  c.kind = kind;
  c.body_a = a;
  c.body_b = b;
  c.time_constant = usual_time_constant;
  c.turn.now = orientation(world, a);
  if (b) c.turn.now = normalised(conjugate(orientation(world, b)) * c.turn.now);
  c.turn.previous = c.turn.now;
  return c;
}

void set_axis(const World& world, Constraint& c, Vec3 axis) {
  c.axis_a = in_frame(world, c.body_a, axis);
  c.axis_b = in_frame(world, c.body_b, axis);
}

void require_range(const char* call, double min, double max, const char* unit) {
  require(!std::isnan(min) && !std::isnan(max), call, ": min and max must be numbers [", unit, "]");
  require(min < max, call, ": min must be below max, got ", min, " and ", max, " ", unit);
  require(std::isfinite(min) || std::isfinite(max), call, ": min or max must be finite");
}

}  // namespace

ConstraintId add_weld(World& world, BodyId a, BodyId b) {
  require_unlocked(world, "weld");
  for (BodyId body : {a, b}) require(world.bodies.alive(body), "weld: ", world.bodies.story(body));
  require_two(world, "weld", a, b);
  Constraint c = tie_of(world, ConstraintKind::weld, a, b);
  const Vec3 middle = 0.5 * (world.motion_of(a).x + world.motion_of(b).x);
  c.own = WeldData{in_frame(world, a, middle - origin(world, a)), in_frame(world, b, middle - origin(world, b))};
  return insert_constraint(world, std::move(c));
}

ConstraintId add_orient(World& world, BodyId body, const OrientDef& def) {
  require_unlocked(world, "orient");
  require_turning(world, "orient", body);
  require_positive("orient", "time_constant", def.time_constant, "s");
  Constraint c = tie_of(world, ConstraintKind::orient, body, {});
  c.time_constant = def.time_constant;
  if (def.to) c.turn.now = unit("orient", *def.to);
  if (def.target) {
    const Lock lock(world);
    c.turn.now = turned_in_plane(world, body, unit("orient", def.target(world.time)));
  }
  c.turn.of_time = def.target;
  start_constraint(world, c);
  return insert_constraint(world, std::move(c));
}

ConstraintId add_align(World& world, BodyId a, BodyId b, const AlignDef& def) {
  require_unlocked(world, "align");
  require_two(world, "align", a, b);
  require_positive("align", "time_constant", def.time_constant, "s");
  Constraint c = tie_of(world, ConstraintKind::align, a, b);
  c.time_constant = def.time_constant;
  c.axis_a = unit_axis("align", "the first axis", def.axis_a);
  c.axis_b = unit_axis("align", "the second axis", def.axis_b);
  rule_of(c).set(c, "align", def.angle.value_or(present_value(world, c)));
  start_constraint(world, c);
  return insert_constraint(world, std::move(c));
}

ConstraintId add_motor(World& world, BodyId a, BodyId b, const MotorDef& def) {
  require_unlocked(world, "motor");
  require_two(world, "motor", a, b);
  require(def.speed.has_value() != def.angle.has_value(), "motor: needs either speed [rad/s] or angle [rad]");
  require_positive_or_infinite("motor", "max_torque", def.max_torque, "N m");
  require_positive("motor", "time_constant", def.time_constant, "s");
  if (def.speed) require_finite("motor", "speed", *def.speed, "rad/s");
  if (def.angle) require_finite("motor", "angle", *def.angle, "rad");
  Constraint c = tie_of(world, ConstraintKind::motor, a, b);
  c.time_constant = def.time_constant;
  c.max_torque = def.max_torque;
  set_axis(world, c, unit_axis("motor", "axis", def.axis));
  c.by_speed = def.speed.has_value();
  c.number.of_time = def.number;
  c.number.now = def.angle.value_or(0.0);
  c.number.rate = def.speed.value_or(0.0);
  start_constraint(world, c);
  return insert_constraint(world, std::move(c));
}

ConstraintId add_limit(World& world, BodyId a, BodyId b, Vec3 axis, const LimitDef& def) {
  require_unlocked(world, "limit");
  require_two(world, "limit", a, b);
  require_range("limit", def.min, def.max, "rad");
  require_positive("limit", "time_constant", def.time_constant, "s");
  Constraint c = tie_of(world, ConstraintKind::limit, a, b);
  c.time_constant = def.time_constant;
  c.low = def.min;
  c.high = def.max;
  set_axis(world, c, unit_axis("limit", "axis", axis));
  start_constraint(world, c);
  return insert_constraint(world, std::move(c));
}

void set_length(World& world, ConstraintId id, double value, std::function<double(double)> function) {
  require_unlocked(world, "a number to keep");
  Constraint& c = world.constraints[id];
  require(rule_of(c).keeps.name != nullptr, "a number to keep: ", describe(world, id), " has none");
  wake(world, c);
  const std::string who = describe(world, id);
  require_kept(who, c, value);
  c.number.of_time = std::move(function);
  if (c.by_speed) {
    c.number.rate = value;
    c.moves = 0;
    return;
  }
  if (rule_of(c).set != nullptr) {
    rule_of(c).set(c, who, value);
    touch(world, c);
  } else {
    c.number.now = value;
  }
  start_constraint(world, c);
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
  require_about_normal(world, "hinge", "axis", unit_axis("hinge", "axis", axis), "");
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
