#include "articulates/islands.hpp"
#include "phases/phases.hpp"

namespace pantin::phases {

namespace {

void save_loose(World& world) {
  world.saved_points.clear();
  for (std::uint32_t slot : world.loose_points) {
    const Point& p = world.points.at_slot(slot);
    world.saved_points.push_back({p.place, p.velocity});
  }
  world.saved_motion.clear();
  for (std::uint32_t slot : world.loose_bodies) world.saved_motion.push_back(world.motion[slot]);
}

}  // namespace

void find_articulates(World& world) {
  const Timed timed(world.profile, Phase::find_articulates);
  pantin::find_articulates(world, world.articulates, world.loose_bodies, world.loose_points);
  save_loose(world);
}

}  // namespace pantin::phases
