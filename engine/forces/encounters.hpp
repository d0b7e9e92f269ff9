#pragma once
// Pairs that passed each other within a stage of a step, faster than their forces could tell at its ends.
#include <vector>

#include "forces/forces.hpp"

namespace pantin {

struct Encounter {
  std::uint32_t site = 0;
  double acceleration = 0.0;  ///< [m/s²] by its law where the two were nearest, on straight lines
  double distance = 0.0;      ///< [m] then
  double displacement = 0.0;  ///< [m] by which the two moved against each other
};

/// Those whose distance was least within the stage, and there well below what it was at the ends. Places at the start are
/// KickNotes::position; `fastest` [m] is the longest displacement of a site in the stage, `nearest` [m] the least distance of two now.
std::vector<Encounter> find_encounters(const World& world, Forces& forces, double fastest, double nearest);

}  // namespace pantin
