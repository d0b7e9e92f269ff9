#pragma once
#include "world/measure.hpp"

namespace pantin {

/// All bodies and free points that hinges and rods tie to a point, itself first.
Things tied_to(const World& world, PointId point);

}  // namespace pantin
