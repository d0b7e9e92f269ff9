#pragma once
#include "contacts/gather.hpp"

namespace pantin {

/// (1 - cos ωh)/ω²h [s]: times ω × (ω × r), the mean velocity [m/s] over a drift h by which turning takes a point off its tangent.
double curving(Vec3 spin, double h);

/// With which velocity [m/s], in the contact's frame, turning alone moves the surfaces of a contact apart, on the mean over a
/// drift h: ω × (ω × r) of both sides, r to what turns with the body.
Vec3 turning_apart(const TouchIsland& island, const IslandContact& contact, const Contact& from, double h);

}  // namespace pantin
