#pragma once
#include "world/world.hpp"

namespace pantin {

/// Before the kicks of a part: notes the accelerations that the laws give.
void note_kicks(World& world);
/// After the forces at its end: local error of the kicks [1/s], the largest over all that laws move, relative to the length
/// of an articulate, else to the spacing of what laws act on where they were spread widest. Two kicks of h and one of 2h leave places that differ by
/// h² times the change of acceleration, a third of which is the error of the two (Richardson 1911).
double kick_error(const World& world);
/// That of the coming step, were it not divided [1/s]: by the forces where all would be at its end if it went on straight,
/// so that what meets a wall in the step is seen before. World::forces must be there.
double coming_kick_error(World& world);

}  // namespace pantin
