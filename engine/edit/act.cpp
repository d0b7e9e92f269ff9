#include "articulates/solve/state.hpp"
#include "edit/common.hpp"
#include "edit/edit.hpp"
#include "forces/sleep.hpp"

namespace pantin {

using namespace internal;

void push(World& world, BodyId body, Vec3 force, std::optional<Vec3> at) {
  require_unlocked(world, "push");
  require_finite("push", "force", force, "N");
  if (at) require_finite("push", "at", *at, "m");
  acted(world);
  Motion& m = world.motion_of(body);
  force = world.plane.along(force);
  m.force += force;
  world.pushed = true;
  wake(world, body);
  if (at) m.torque += rotate(m.q, turning_part(m, cross(*at - m.x, force)));
}

void kick(World& world, BodyId body, Vec3 impulse, std::optional<Vec3> at) {
  require_unlocked(world, "kick");
  require_finite("kick", "impulse", impulse, "N s");
  if (at) require_finite("kick", "at", *at, "m");
  require_in_plane(world, "kick", "impulse", impulse, "N s");
  acted(world);
  Motion& m = world.motion_of(body);
  const double before = energy_of(world, body);
  disturb_forces_by_motion(world);
  m.p += world.plane.along(impulse);
  if (at) m.angular += turning_part(m, cross(*at - m.x, impulse));
  post(world, Source::event, energy_of(world, body) - before);
  disturb(world, body);
}

void twist(World& world, BodyId body, Vec3 torque) {
  require_unlocked(world, "twist");
  require_finite("twist", "torque", torque, "N m");
  Motion& m = world.motion_of(body);
  require(m.freedom != Freedom::point, "twist: ", describe(world, body),
          " cannot turn: its points are at one position, and it has no inertia");
  const double along = m.freedom == Freedom::line ? std::fabs(dot(rotate(m.q, vec(1, 0, 0)), torque)) : 0.0;
  require(along <= 1e-9 * norm(torque), "twist: ", describe(world, body),
          " cannot turn about the line of its points, but the torque has ", along, " N m about it; give it `inertia`");
  acted(world);
  m.torque += world.plane.about(torque);
  world.pushed = true;
  wake(world, body);
}

void push(World& world, PointId id, Vec3 force) {
  require_unlocked(world, "push");
  Point& point = world.points[id];
  if (point.body) return push(world, point.body, force, position(world, id));
  require_finite("push", "force", force, "N");
  acted(world);
  point.force += world.plane.along(force);
  world.pushed = true;
  wake(world, id);
}

void kick(World& world, PointId id, Vec3 impulse) {
  require_unlocked(world, "kick");
  Point& point = world.points[id];
  if (point.body) return kick(world, point.body, impulse, position(world, id));
  require_finite("kick", "impulse", impulse, "N s");
  require_in_plane(world, "kick", "impulse", impulse, "N s");
  acted(world);
  const double before = energy_of(world, id);
  disturb_forces_by_motion(world);
  world.motion_of(id).v += world.plane.along(impulse) / point.mass;
  post(world, Source::event, energy_of(world, id) - before);
  disturb(world, id);
}

}  // namespace pantin
