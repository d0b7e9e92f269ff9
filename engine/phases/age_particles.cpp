#include <algorithm>

#include "phases/phases.hpp"
#include "world/edit.hpp"

namespace pantin::phases {

void age_particles(World& world) {
  const Timed timed(world.profile, Phase::age_particles);
  if (world.mortals.empty()) return;
  std::vector<ParticleId> ended;
  std::erase_if(world.mortals, [&](ParticleId id) {
    if (!world.particles.alive(id)) return true;
    const Particle& p = world.particles[id];
    if (p.asleep_in || p.born + p.lifetime > world.time) return false;
    ended.push_back(id);
    return true;
  });
  const auto who = world.who;
  world.who = [] { return std::string("the end of its lifetime"); };
  for (ParticleId id : ended) {
    if (!world.particles.alive(id)) continue;
    const Point& point = world.points[world.particles[id].points[0]];
    if (point.body && !world.particles[id].is_hinge())
      remove_point(world, world.particles[id].points[0]);
    else
      remove(world, id);
  }
  world.who = who;
}

}  // namespace pantin::phases
