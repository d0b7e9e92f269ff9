#pragma once
#include "world/world.hpp"

namespace pantin {

/// Whether a blow or a push may break something in this step.
bool may_break_at_once(const World& world);
/// After the stages of a step: whether a blow or a push was far too much for something. That broke before it bore any of it, then:
/// all is as it was at the start of the step but for what broke, and the step is to be done again. Of several those break first
/// that bore most of what they can.
bool breaks_at_once(World& world);

}  // namespace pantin
