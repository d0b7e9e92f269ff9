#pragma once
#include "measure/measure.hpp"

namespace pantin {

/// All bodies and free points that hinges and constraints tie to a point or body, itself first; connections too where that
/// is asked for.
Things tied_to(const World& world, PointId point, bool by_connections);
Things tied_to(const World& world, BodyId body, bool by_connections);

}  // namespace pantin
