#pragma once
// The local error of the kicks of a step, for `scene.accuracy`.
#include <string>

#include "world/world.hpp"

namespace pantin {

/// After the kick that begins a stage of a step: notes the accelerations in it, and where all is.
void note_kicks(World& world);
/// After the kick at its end: the error [1/s], largest over all that laws move. Kicks of h leave positions that are wrong by h/6
/// times the change of acceleration in each second (Hairer, Lubich and Wanner 2003). For two that interact, of what changes
/// between them, relative to their distance; else relative to how far a thing swings beside a uniform motion. Never to
/// where it is or how far it has come. Laws that act only where two have met within the stage are seen too: what passed
/// each other is asked where it was nearest; and forces of time once between the ends. Noise is left out. Infinite where it
/// is not a number.
double kick_error(World& world);
/// A step was rejected and is to be done again: what was noted of it is not so.
void forget_rejected(World& world);
/// A step is done: notes how things swing.
void note_swings(World& world);
/// The law that moves most what had the largest error in `kick_error`, as messages name it.
std::string law_of_worst_error(World& world);

}  // namespace pantin
