#pragma once
// Temporal sequencing: setting what is to happen, and having it happen.
#include <vector>

#include "world/world.hpp"

namespace pantin {

/// Times must be finite, and not past.
EventId add_event(World& world, Event event);
/// Nothing happens when it is done already.
void cancel(World& world, EventId event);
/// Fires what is due up to `time` [s], when the step begins. An event whose target is gone is dropped and logged with who removed it.
void fire_due(World& world, double time);
/// What ended, then what waits in the order in which it is due (whens last): the latest and the next `most_told`.
std::vector<TimelineEntry> timeline(const World& world);

}  // namespace pantin
