#include "edit/emitter.hpp"
#include "edit/life.hpp"
#include "step/phases.hpp"

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
  if (world.mortals.empty() && world.emitters.empty()) return;
  const Timed timed(world.profile, Phase::age_particles);
  const std::vector<ParticleId> ended = take_ended(world, with_round_off(world.time));
  if (!ended.empty()) {
    const Acting acting(world);
    world.who = [] { return std::string("the end of its lifetime"); };
    for (ParticleId id : ended)
      if (world.particles.alive(id)) end_life(world, id);
  }
  emit(world);
}

}  // namespace pantin::phases
