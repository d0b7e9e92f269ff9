// Joins: two points drawn together.
#include "constraints/kind.hpp"
#include "edit/assemble.hpp"
#include "edit/parts.hpp"

namespace pantin {

using namespace internal;

namespace {

void require_joinable(const World& world, PointId a, PointId b) {
  for (PointId p : {a, b}) require(world.points.alive(p), "join: ", world.points.story(p));
  const Point &first = world.points[a], &second = world.points[b];
  require(a != b, "join: both are ", describe(world, a), "; it needs two points");
  require(!first.body || first.body != second.body, "join: both points belong to ", describe(world, first.body),
          "; it joins different bodies");
  require(first.particle != second.particle, "join: these points are joined already, in ",
          describe(world, first.particle));
}

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
  require_unlocked(world, "join");
  require_joinable(world, a, b);
  require_positive("join", "time_constant", def.time_constant, "s");
  require_positive_or_infinite("join", "max_force", def.max_force, "N");
  Constraint c;
  c.kind = ConstraintKind::join;
  c.a = a;
  c.b = b;
  c.max_force = def.max_force;
  c.time_constant = def.time_constant;
  require_in_plane(world, c);
  start_constraint(world, c);
  const ConstraintId holder = add_holder(world, a, def);
  const auto progress = std::make_shared<JoinProgress>();
  progress->holder = holder;
  progress->on_met = def.on_met;
  progress->hinge_name = def.name;
  progress->label = world.who ? world.who() : "";
  c.own = JoinData{progress};
  return insert_constraint(world, std::move(c));
}

}  // namespace pantin
