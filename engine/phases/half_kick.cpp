#include "phases/phases.hpp"

namespace pantin::phases {

void half_kick(World& world) {
  const Timed timed(world.profile, Phase::half_kick);
  const double half = 0.5 * world.settings.step;
  for (std::uint32_t slot : world.loose_points) {
    Point& p = world.points.at_slot(slot);
    const Vec3 before = p.velocity;
    p.velocity += (world.settings.gravity + p.force / p.mass) * half;
    world.work += dot(p.force, before + p.velocity) * (0.5 * half);
  }
}

}  // namespace pantin::phases
