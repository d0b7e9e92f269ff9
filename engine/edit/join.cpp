// Joins: two points drawn together.
#include "constraints/kind.hpp"
#include "edit/assemble.hpp"
#include "edit/common.hpp"
#include "edit/constrain.hpp"
#include "edit/parts.hpp"

namespace pantin {

using namespace internal;

namespace {

/// What draws the first point to where they are to meet.
ConstraintId add_holder(World& world, PointId point, const JoinDef& def) {
  if (!def.at) return {};
  require_finite("join", "at", *def.at, "m");
  if (!std::isfinite(def.max_force)) return add_nail(world, point, def.at, def.time_constant);
  FollowDef follow;
  follow.at = *def.at;
  follow.max_force = def.max_force;
  follow.time_constant = def.time_constant;
  return add_follow(world, point, follow);
}

}  // namespace

ConstraintId add_join(World& world, PointId a, PointId b, const JoinDef& def) {
  require_point(world, "join", b);
  require_finite("join", "axis", def.axis, "");
  const bool turns_about_axis = norm2(def.axis) > 0.0;
  require(!turns_about_axis || (world.points[a].body && world.points[b].body),
          "join: only bodies turn about an axis, and one of these is a free particle");
  Constraint c;
  c.kind = ConstraintKind::join;
  c.a = a;
  c.b = b;
  c.max_force = def.max_force;
  c.time_constant = def.time_constant;
  check_constraint(world, c);
  const ConstraintId holder = add_holder(world, a, def);
  const auto progress = std::make_shared<JoinProgress>();
  progress->holder = holder;
  progress->on_met = def.on_met;
  progress->hinge_name = def.name;
  progress->hinge_axis = def.axis;
  progress->label = world.who ? world.who() : "";
  c.own = JoinData{progress};
  return add_constraint(world, std::move(c));
}

}  // namespace pantin
