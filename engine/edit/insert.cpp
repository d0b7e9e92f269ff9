// How constraints come into a world, and leave it.
#include "edit/common.hpp"

namespace pantin::internal {

ConstraintId insert_constraint(World& world, Constraint c) {
  require_in_plane(world, c);
  c.serial = world.next_serial++;
  const ConstraintId id = world.constraints.add(std::move(c));
  const Constraint& row = world.constraints[id];
  row.each_point([&](PointId point) { world.points[point].constraints.push_back(id); });
  row.each_body([&](BodyId body) {
    world.bodies[body].constraints.push_back(id);
    if (world.motion_of(body).freedom == Freedom::line) update_mass(world, body);
  });
  touch(world, row);
  return id;
}

void take_out_constraint(World& world, ConstraintId id, Obituary obituary) {
  const Constraint& c = world.constraints[id];
  touch(world, c);
  c.each_point([&](PointId point) { std::erase(world.points[point].constraints, id); });
  c.each_body([&](BodyId body) { std::erase(world.bodies[body].constraints, id); });
  if (c.ring() && world.particles.alive(c.ring())) std::erase(world.particles[c.ring()].axes, id);
  const std::shared_ptr<JoinProgress> progress = c.progress();
  world.constraints.remove(id, obituary);
  if (progress && world.constraints.alive(progress->holder))
    take_out_constraint(world, progress->holder, {describe(world, progress->holder), obituary.time, obituary.who});
}

}  // namespace pantin::internal
