#pragma once
// The local error of the kicks of a step, for `scene.accuracy`.
#include <string>

#include "world/world.hpp"

namespace pantin {

/// After the kick that begins a part of a step: notes the accelerations in it, and where all is.
void note_kicks(World& world);
/// After the kick at its end: the error [1/s], largest over all that laws move, relative to the size of what it interacts
/// with. Two kicks of h and one of 2h leave places that differ by h² times the change of acceleration, a third of which is
/// the error of the two (Richardson 1911). Laws that act only where two have met within the part are seen too: what passed
/// each other is asked where it was nearest. Noise is left out. Infinite where it is not a number.
double kick_error(World& world);
/// The law that moves most what had the largest error in `kick_error`, as messages name it.
std::string law_of_worst_error(World& world);

}  // namespace pantin
