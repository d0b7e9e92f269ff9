#include <algorithm>

#include "phases/phases.hpp"
#include "world/edit.hpp"

namespace pantin::phases {

namespace {

void end_life(World& world, ParticleId id) {
  const PointId point = world.particles[id].points[0];
  const bool of_body = !world.particles[id].is_hinge() && world.points[point].body;
  if (!of_body) return remove(world, id);
  try {
    remove_point(world, point);
  } catch (const Error& error) {
    // A body cannot do without the point that has its mass.
    log_line(world, "dropped", text("end of the lifetime of ", describe(world, point), ": ", error.what()));
  }
}

}  // namespace

void age_particles(World& world) {
  const Timed timed(world.profile, Phase::age_particles);
  if (world.mortals.empty()) return;
  std::vector<ParticleId> ended;
  std::erase_if(world.mortals, [&](ParticleId id) {
    if (!world.particles.alive(id)) return true;
    const Particle& p = world.particles[id];
    if (!std::isfinite(p.lifetime)) return true;
    if (p.asleep_in || p.born + p.lifetime > world.time) return false;
    ended.push_back(id);
    return true;
  });
  if (ended.empty()) return;
  const Acting acting(world);
  world.who = [] { return std::string("the end of its lifetime"); };
  for (ParticleId id : ended)
    if (world.particles.alive(id)) end_life(world, id);
}

}  // namespace pantin::phases
