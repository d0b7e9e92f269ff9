#pragma once
// Not for use outside world/.
#include <memory>
#include <utility>
#include <vector>

#include "world/forces.hpp"

namespace pantin {

/// Makes the laws of the model ready to act; null where there are none. Places are not yet read.
std::unique_ptr<Forces> build_forces(const World& world);
/// Gives the fields their sites; after every change of their order.
void arrange_fields(const World& world, Forces& forces);
/// Evaluates laws that depend on velocities again, at the present ones.
void run_moving_laws(World& world, Forces& forces);
/// The particles of a point, body, particle or group, as they were made: some may sleep in hinges.
std::vector<ParticleId> particles_of(const World& world, const AnyId& thing);
/// From pairs of n sites, each in both orders.
Exclusions exclusions(std::size_t n, std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs);

}  // namespace pantin
