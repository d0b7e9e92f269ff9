#pragma once
// What hands copy, mirror and take away as a whole: a thing with all that is joined to it.
#include "measure/measure.hpp"
#include "world/world.hpp"

namespace pantin {

/// The bodies and free points that hinges, rods, ropes, springs and the like join to what the command means; it too.
Things whole_of(const World& world, const Command& command);

/// Another of all that is joined to the thing that is meant, whose centre comes to `position` [m]; mirrored along `amount`,
/// where that has a length. It moves as that does. Throws Error where it cannot be, and nothing is changed.
void copy_by_hand(World& world, const Command& command);
/// Takes all away that is joined to the thing that is meant, and it.
void remove_whole(World& world, const Command& command);

}  // namespace pantin
