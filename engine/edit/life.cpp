#include "edit/life.hpp"

#include <algorithm>
#include <cmath>

namespace pantin {

namespace {

bool later(const Mortal& a, const Mortal& b) { return a.time != b.time ? a.time > b.time : a.serial > b.serial; }

/// Takes out what is gone or waits for another time, once it is most of the queue.
void tidy(World& world) {
  if (world.mortals.size() <= 2 * world.particles.size() + 64) return;
  std::erase_if(world.mortals, [&](const Mortal& m) {
    return !world.particles.alive(m.particle) || world.particles[m.particle].awaited != m.time;
  });
  std::make_heap(world.mortals.begin(), world.mortals.end(), later);
}

}  // namespace

void await_end(World& world, ParticleId id) {
  Particle& particle = world.particles[id];
  const double end = particle.born + particle.lifetime;
  if (!std::isfinite(particle.lifetime) || particle.awaited <= end) return;
  particle.awaited = end;
  world.mortals.push_back({end, particle.serial, id});
  std::push_heap(world.mortals.begin(), world.mortals.end(), later);
  tidy(world);
}

std::vector<ParticleId> take_ended(World& world, double time) {
  std::vector<ParticleId> ended;
  while (!world.mortals.empty() && world.mortals.front().time <= time) {
    std::pop_heap(world.mortals.begin(), world.mortals.end(), later);
    const Mortal mortal = world.mortals.back();
    world.mortals.pop_back();
    if (!world.particles.alive(mortal.particle)) continue;
    Particle& particle = world.particles[mortal.particle];
    if (particle.awaited != mortal.time) continue;
    particle.awaited = std::numeric_limits<double>::infinity();
    if (particle.asleep_in) continue;
    if (particle.born + particle.lifetime <= time)
      ended.push_back(mortal.particle);
    else
      await_end(world, mortal.particle);
  }
  return ended;
}

}  // namespace pantin
