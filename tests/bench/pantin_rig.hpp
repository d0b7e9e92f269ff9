#pragma once
#include <string>
#include <vector>

#include "peers/trial.hpp"
#include "world/world.hpp"

namespace pantin {

/// Pantin's own ways to move a mechanism: every integrator, without the energy return and with it (" + return").
std::vector<peers::Setting> pantin_settings();

/// Puts a mechanism, with the shapes and walls that it has, into a world; returns its solids.
std::vector<BodyId> add_mechanism(World& world, const peers::Mechanism& mechanism);
/// Where these are, and how fast.
void read_solids(const World& world, const std::vector<BodyId>& bodies, std::vector<peers::SolidState>& state);

/// A world as a scene has it where it sets nothing.
peers::Setting pantin_pile_setting();

}  // namespace pantin
