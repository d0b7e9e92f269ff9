#pragma once
#include "measure/measure.hpp"

namespace pantin {

/// All bodies and free points that hinges and rods tie to a point, itself first; connections too where that is asked for.
Things tied_to(const World& world, PointId point, bool by_connections);

}  // namespace pantin
