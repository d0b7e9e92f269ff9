#include "constraints/kind.hpp"
#include "edit/common.hpp"
#include "edit/constrain.hpp"
#include "forces/sleep.hpp"

namespace pantin {

using namespace internal;

namespace {

ConstraintId add_rod_row(World& world, Constraint c, Vec3 far_end, std::optional<double> length) {
  const double distance = norm(position(world, c.a) - far_end);
  c.kind = ConstraintKind::rod;
  c.number.now = length.value_or(distance);
  rule_of(c).check(world, c);
  require(length || distance > 0.0, "rod: its ends are at one position, so it has no length; a length must be > 0 m");
  check_constraint(world, c);
  require(std::fabs(distance - c.number.now) <= world.settings.tolerance * c.number.now, "rod: its ends are ", distance,
          " m apart, but its length is given as ", c.number.now, " m; move them first, or set the length afterwards");
  return add_constraint(world, std::move(c));
}

Constraint& of_kind(World& world, ConstraintId id, ConstraintKind kind, const char* call) {
  require_unlocked(world, call);
  Constraint& c = world.constraints[id];
  require(c.kind == kind, call, ": ", describe(world, id), " has none");
  wake(world, c);
  return c;
}

}  // namespace

ConstraintId add_nail(World& world, PointId point, std::optional<Vec3> at, double time_constant) {
  require_point(world, "nail", point);
  Constraint c;
  c.kind = ConstraintKind::nail;
  c.a = point;
  c.time_constant = time_constant;
  c.position.now = at ? *at : position(world, point);
  return add_constraint(world, std::move(c));
}

ConstraintId add_follow(World& world, PointId point, const FollowDef& def) {
  require(def.hand >= -1, "follow: hand must be the number of one, or -1 for none, got ", def.hand);
  Constraint c;
  c.kind = ConstraintKind::follow;
  c.a = point;
  c.max_force = def.max_force;
  c.time_constant = def.time_constant;
  c.hand = def.hand;
  if (def.hand < 0) c.position.of_time = def.target;
  require_point(world, "follow", point);
  c.position.now = position(world, point);
  check_constraint(world, c);
  Vec3 at = def.at;
  if (def.hand >= 0) {
    const auto hand = static_cast<std::size_t>(def.hand);
    require(hand < world.hands.size(), "follow: there is no hand ", hand + 1);
    require(world.hands[hand].placed, "follow: hand ", hand + 1, " has no position yet");
    at = world.hands[hand].position;
  } else if (def.target) {
    at = present(world, def.target);
  }
  if ((def.hand >= 0 || def.target) && finite(at)) at = world.plane.beside(at, position(world, point));
  c.position.now = at;
  return add_constraint(world, std::move(c));
}

ConstraintId add_rod(World& world, PointId a, PointId b, std::optional<double> length) {
  for (PointId point : {a, b}) require_point(world, "rod", point);
  Constraint c;
  c.a = a;
  c.b = b;
  return add_rod_row(world, std::move(c), position(world, b), length);
}

ConstraintId add_rod(World& world, PointId a, Vec3 position, std::optional<double> length) {
  require_point(world, "rod", a);
  Constraint c;
  c.a = a;
  c.position.now = position;
  return add_rod_row(world, std::move(c), position, length);
}

void set_enabled(World& world, ConstraintId id, bool enabled) {
  require_unlocked(world, "enabled");
  Constraint& c = world.constraints[id];
  if (c.enabled == enabled) return;
  mark_edited(world, c);
  c.enabled = enabled;
  c.force = c.torque = zero3();
  c.tension = 0.0;
  if (!enabled) return;
  start_constraint(world, c);
}

void set_target(World& world, ConstraintId follow, std::function<Vec3(double)> target) {
  Constraint& c = of_kind(world, follow, ConstraintKind::follow, "target");
  require(c.hand < 0, "target: ", describe(world, follow), " belongs to hand ", c.hand + 1, " and goes where it goes");
  Vec3 position = target ? present(world, target) : c.position.now;
  require_finite("follow", "target", position, "m");
  position = world.plane.beside(position, c.position.now);
  c.position.now = position;
  start_constraint(world, c);
  c.position.of_time = std::move(target);
  mark_edited(world, c);
}

void set_position(World& world, ConstraintId id, Vec3 position) {
  require_unlocked(world, "position");
  Constraint& c = world.constraints[id];
  const std::string who = describe(world, id);
  require_finite(who, "position", position, "m");
  require(c.hand < 0, who, ": it belongs to hand ", c.hand + 1, " and goes where it goes");
  if (c.kind == ConstraintKind::rod) {
    require(!c.b, who, ": both its ends are points; move those");
    mark_edited(world, c);
  }
  if (rule_of(c).ends_at_position) require_height(world, who, "position", position, c.position.now);
  wake(world, c);
  c.position.of_time = nullptr;
  c.position.now = position;
  start_constraint(world, c);
}

void set_max_force(World& world, ConstraintId follow, double force) {
  Constraint& c = of_kind(world, follow, ConstraintKind::follow, "max_force");
  require_positive_or_infinite("follow", "max_force", force, "N");
  const bool was = std::isfinite(c.max_force), is = std::isfinite(force);
  if (was && !is) require_free_of_holders(world, "follow", c.a);
  c.max_force = force;
  if (was == is) return;
  start_constraint(world, c);
  mark_edited(world, c);
}

}  // namespace pantin
