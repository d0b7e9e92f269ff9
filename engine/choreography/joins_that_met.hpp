#pragma once
#include "world/world.hpp"

namespace pantin {

/// Makes the hinges of joins whose points met in the step just done.
void make_met_hinges(World& world);

}  // namespace pantin
