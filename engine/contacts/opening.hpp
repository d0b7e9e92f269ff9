#pragma once
#include "contacts/gather.hpp"

namespace pantin {

/// (1 - cos ωh)/ω²h [s]: times ω × (ω × r), the mean velocity [m/s] over a drift h by which turning takes a point off its tangent.
double curving(Vec3 spin, double h);

/// How fast [m/s], on the mean over a drift h, turning alone opens a contact of an island: by n·(ω × (ω × r)) of both sides, less
/// what round surfaces have behind them.
double opening(const TouchIsland& island, const IslandContact& contact, const Contact& from, double h);

}  // namespace pantin
