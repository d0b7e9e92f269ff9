// A scene in a plane: what must lie in it, and how things that are there already are put into it.
#include <algorithm>

#include "edit/common.hpp"
#include "model/path.hpp"

namespace pantin {

namespace {

using namespace internal;

void require_things_in_plane(const World& world) {
  for (PointId id : world.points.ids())
    if (!world.points[id].body)
      require_in_plane(world, "plane", "the velocity of " + describe(world, id), world.motion_of(id).v, "m/s");
  for (BodyId id : world.bodies.ids()) {
    const Motion& m = world.motion_of(id);
    require_in_plane(world, "plane", "the velocity of " + describe(world, id), m.p / m.mass, "m/s");
    require_about_normal(world, "plane", "the spin of " + describe(world, id), angular_velocity(m), "rad/s");
  }
  for (EmitterId id : world.emitters.ids())
    require_in_plane(world, "plane", "the velocity of " + describe(world, id), world.emitters[id].velocity, "m/s");
  for (ConstraintId id : world.constraints.ids()) require_in_plane(world, world.constraints[id]);
}

/// Throws Error where a body cannot be weighed in the plane; it is then as it was.
void put_bodies_in_plane(World& world) {
  std::vector<std::pair<Body, Motion>> before;
  const std::vector<BodyId> ids = world.bodies.ids();
  try {
    for (BodyId id : ids) {
      before.emplace_back(world.bodies[id], world.motion_of(id));
      update_mass(world, id);
      mark_edited(world, id);
    }
  } catch (const Error&) {
    for (std::size_t i = 0; i < before.size(); i++) {
      world.bodies[ids[i]] = before[i].first;
      world.motion_of(ids[i]) = before[i].second;
    }
    throw;
  }
}

}  // namespace

void set_plane(World& world, Plane plane) {
  require_unlocked(world, "plane");
  require(plane.normal >= -1 && plane.normal < static_cast<int>(plane_names.size()),
          "plane: its normal must be an axis, 0 to 2, or -1 for none, got ", plane.normal);
  if (plane.normal == world.plane.normal) return;
  require(!world.plane.flat(), "plane: it is \"",
          plane_names[static_cast<std::size_t>(std::max(world.plane.normal, 0))],
          "\" already, and things have been put into that; set it once, before things are made");
  acted(world);
  disturb_forces(world);
  world.plane = plane;
  try {
    require_things_in_plane(world);
    put_bodies_in_plane(world);
  } catch (const Error&) {
    world.plane = {};
    throw;
  }
  for (PointId id : world.points.ids())
    if (!world.points[id].body) {
      world.motion_of(id).v = plane.along(world.motion_of(id).v);
      mark_edited(world, id);
    }
  for (EmitterId id : world.emitters.ids()) world.emitters[id].velocity = plane.along(world.emitters[id].velocity);
  for (ConstraintId id : world.constraints.ids()) mark_edited(world, world.constraints[id]);
  world.stiffness_unknown = true;
  set_gravity(world, world.settings.gravity);
}

}  // namespace pantin
