#pragma once
#include <algorithm>
#include <cmath>

#include "measure/measure.hpp"

namespace pantin {

/// What errors of the energy are relative to, [J]: the largest of the kinetic energy so far, the work from outside, the
/// change of the energy, what a kick of laws without energy could give, and 1e-8 of the potential energy: round-off is all
/// that changes in a scene at rest.
inline double energy_scale(const World& world, const Energy& now) {
  return std::max({world.largest_kinetic, std::fabs(world.work), std::fabs(now.total() - world.start_energy),
                   world.work_check.kick, 1e-8 * std::fabs(now.potential)});
}

}  // namespace pantin
