#pragma once
#include "contacts/gather.hpp"

namespace pantin {

/// By how much turning alone opens a contact of an island [m/s²]: n·(ω × (ω × r)) of both sides, less what round surfaces have
/// behind them.
double opening(const TouchIsland& island, const IslandContact& contact, const Contact& from);

}  // namespace pantin
