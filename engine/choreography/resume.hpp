#pragma once
// Beginning in the middle: for a world that goes on where another one is.
#include "world/world.hpp"

namespace pantin {

/// Sets the clock of a world that has not moved yet to `time` [s]: what was due up to `fired` [s] counts as fired, plays
/// begin then.
void begin_at(World& world, double time, double fired);
/// Ends an event that waits, without firing it.
void end_event(World& world, EventId event, EventState state);

}  // namespace pantin
