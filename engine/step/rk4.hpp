#pragma once
#include "world/world.hpp"

namespace pantin::phases {

/// One of the four stages of Kutta's method: takes the slopes at the present state, and moves loose points and bodies from
/// the start of the step to where the next are taken, or, after the fourth, to its end.
void take_rk4_stage(World& world);

}  // namespace pantin::phases
