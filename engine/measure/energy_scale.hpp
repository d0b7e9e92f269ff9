#pragma once
#include <algorithm>
#include <cmath>

#include "articulates/articulate.hpp"
#include "forces/forces.hpp"
#include "measure/measure.hpp"

namespace pantin {

/// [J] What is too little to count of what is tied: its weight, and what laws pull it with, times 1e-8 of its length, and the
/// motion by 1e-12 of that in a step. All that changes in a mechanism at rest is round-off, wherever it is.
inline double negligible_energy(const World& world) {
  const double g = norm(world.settings.gravity);
  double sum = 0.0;
  if (world.forces)
    for (const Receiver& r : world.forces->receivers)  // of what there was before the last edit
      if (const auto k = static_cast<std::size_t>(r.articulate); r.articulate >= 0 && k < world.articulates.size())
        sum += 1e-8 * norm(r.force + r.nonconservative_force) * world.articulates[k]->length;
  for (const auto& a : world.articulates) {
    const double speed = 1e-12 * a->length / world.settings.step;
    sum += a->total_mass * (1e-8 * g * a->length + 0.5 * speed * speed);
  }
  return sum;
}

/// What errors of the energy are relative to, [J]: the largest of the kinetic energy so far, the work from outside, the
/// change of the energy, what a kick of laws without energy could give, 1e-8 of the potential energy, and what is negligible.
inline double energy_scale(const World& world, const Energy& now) {
  return std::max({world.largest_kinetic, std::fabs(world.work), std::fabs(now.total() - world.start_energy),
                   world.work_check.kick, 1e-8 * std::fabs(now.potential), negligible_energy(world)});
}

}  // namespace pantin
