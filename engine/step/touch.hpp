#pragma once
#include "world/world.hpp"

namespace pantin {

/// Whether something can touch, or could: else what follows, and the phases of contacts, do nothing.
inline bool may_touch(const World& world) { return !world.shapes.empty() || world.solids || world.touch_space; }

/// Before a step: things that are near each other and fast for their size are moved in up to four sub-steps.
void divide_for_contacts(World& world);
/// After forces are found: posts what laws that kick did while overlaps were opened.
void post_opening(World& world);

}  // namespace pantin
