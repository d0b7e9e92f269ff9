#include "edit/common.hpp"
#include "edit/edit.hpp"

namespace pantin {

using namespace internal;

void remove(World& world, BodyId id) {
  require_unlocked(world, "remove");
  const std::string what = describe(world, id);
  disturb_sites(world);
  mark_edited(world, id);
  post(world, Source::removal, -energy_of(world, id));
  const std::vector<PointId> points = world.bodies[id].points;
  const std::vector<std::string> names = describe_points(world, id);
  for (std::size_t i = 0; i < points.size(); i++) erase_point(world, points[i], names[i]);
  const std::vector<ConstraintId> constraints = world.bodies[id].constraints;
  for (ConstraintId c : constraints) remove(world, c);
  erase_shapes(world, id, culprit(world));
  world.bodies.remove(id, obituary(world, what));
  world.motion[id.slot - 1] = Motion{};
  notice(world, Notice::Kind::removed, id, world.bodies.story(id));
}

void remove(World& world, PointId id) {
  require_unlocked(world, "remove");
  const Point& point = world.points[id];
  const std::string what = describe(world, id);
  require(!point.body, "remove: ", what, " goes with its body; use remove_point to take it off");
  const ParticleId own = point.own;
  disturb_forces_by_death(world, own);
  mark_edited(world, id);
  drop_contacts(world.contacts, point_thing(id.slot - 1));
  post(world, Source::removal, -energy_of(world, id));
  erase_point(world, id, what);
  notice(world, Notice::Kind::removed, own, world.particles.story(own));
}

void remove(World& world, ParticleId id) {
  require_unlocked(world, "remove");
  if (world.particles[id].is_hinge()) return cut(world, id);
  remove(world, world.particles[id].points[0]);
}

void remove(World& world, ConstraintId id) {
  require_unlocked(world, "remove");
  const bool grabbed = let_go(world, id);
  take_out_constraint(world, id, obituary(world, describe(world, id)));
  if (!grabbed) notice(world, Notice::Kind::removed, id, world.constraints.story(id));
}

void remove(World& world, GroupId id) {
  require_unlocked(world, "remove");
  const std::string what = describe(world, id);
  world.groups.remove(id, obituary(world, what));
}

void remove(World& world, const AnyId& thing) {
  std::visit(
      [&](const auto& id) {
        if constexpr (std::is_same_v<std::decay_t<decltype(id)>, std::monostate>)
          throw Error("remove: nothing was given");
        else
          remove(world, id);
      },
      thing);
}

void remove_point(World& world, PointId id) {
  require_unlocked(world, "remove_point");
  const BodyId body = world.points[id].body;
  const std::string what = describe(world, id);
  require(static_cast<bool>(body), "remove_point: ", what, " belongs to no body; use remove");
  const ParticleId own = world.points[id].own;
  const double before = energy_of(world, body);
  disturb_sites(world);
  auto& points = world.bodies[body].points;
  const std::vector<PointId> all = points;
  std::erase(points, id);
  try {
    update_mass(world, body);
  } catch (const Error&) {
    points = all;
    throw;
  }
  mark_edited(world, body);
  erase_point(world, id, what);
  post(world, Source::edit, energy_of(world, body) - before);
  notice(world, Notice::Kind::removed, own, world.particles.story(own));
}

}  // namespace pantin
