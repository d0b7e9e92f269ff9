#pragma once
// Ends of lives: a queue of the particles with a finite lifetime.
#include <vector>

#include "world/world.hpp"

namespace pantin {

/// Puts a particle with a finite lifetime into the queue, unless it is there for an earlier time.
void await_end(World& world, ParticleId particle);
/// Takes those whose lives end up to `time` [s] out of the queue, earliest first. One that sleeps in a hinge is not told
/// of: it wakes without a lifetime.
std::vector<ParticleId> take_ended(World& world, double time);

}  // namespace pantin
