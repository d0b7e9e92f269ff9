#pragma once
#include <span>

#include "measure/measure.hpp"

namespace pantin {

/// Carries out what hands asked for, by the functions that scripts call. What cannot be done is no fault of the scene, as
/// a thing may have gone on the way: it is dropped, and the log says why.
void carry_out(World& world, std::span<const Command> commands);

/// What the command "heat" reaches: the bodies and free points with a particle in the ball [m], and bodies without any whose
/// shapes reach into it; of one alone, which has no heat, all that hinges and rods tie to it.
Things heated_by(const World& world, Vec3 position, double radius);
/// Whether that heats anything: a single thing at rest has no motion relative to itself.
bool takes_heat(const World& world, const Things& things, double joules);

}  // namespace pantin
