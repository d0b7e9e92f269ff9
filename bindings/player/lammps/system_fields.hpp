#pragma once
// Fields of a scene as LAMMPS has them: forces by formulas, and heat baths.
#include "player/lammps/system.hpp"

namespace pantin::player {

/// Adds fields at work to a system that has its types. Throws Error for what LAMMPS has not.
void add_fields(const World& world, LammpsSystem& system);

}  // namespace pantin::player
