#pragma once
#include "world/world.hpp"

namespace pantin {

/// Moves the world by one step. Throws what a script's callback throws, and Error where World::settings cannot be or a step
/// is under way. A state that became non-finite sets World::failure, names the row, and keeps the last good state.
void step(World& world);
/// Steps until the time is at least `until` [s], less half a step.
void advance(World& world, double until);

}  // namespace pantin
