#pragma once
// Mechanisms and piles, as every engine gets them, in a world.
#include <vector>

#include "peers/mechanism.hpp"
#include "peers/trial.hpp"
#include "world/world.hpp"

namespace pantin::support {

/// Puts a mechanism, with the shapes and walls that it has, into a world; returns its solids.
std::vector<BodyId> add_mechanism(World& world, const peers::Mechanism& mechanism);
/// Where these are, and how fast.
void read_solids(const World& world, const std::vector<BodyId>& bodies, std::vector<peers::SolidState>& state);

}  // namespace pantin::support
