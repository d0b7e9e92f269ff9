#include "articulates/islands.hpp"
#include "phases/phases.hpp"
#include "world/editing.hpp"

namespace pantin::phases {

namespace {

void save_loose(World& world) {
  world.saved_points.clear();
  for (std::uint32_t slot : world.loose_points) world.saved_points.push_back(world.free_motion[slot]);
  world.saved_motion.clear();
  for (std::uint32_t slot : world.loose_bodies) world.saved_motion.push_back(world.motion[slot]);
}

}  // namespace

void find_articulates(World& world) {
  const Timed timed(world.profile, Phase::find_articulates);
  if (world.topology_changed) editing::disturb_forces(world);
  pantin::find_articulates(world, world.articulates, world.loose_bodies, world.loose_points);
  save_loose(world);
}

}  // namespace pantin::phases
