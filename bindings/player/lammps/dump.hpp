#pragma once
// What LAMMPS wrote of its atoms, and how it comes back into the scene.
#include <array>
#include <string>
#include <vector>

#include "player/lammps/system.hpp"

namespace pantin::player {

/// Of each atom six numbers, by its number less 1: positions and velocities [m], [m/s], or forces [N] as the first three.
using DumpedAtoms = std::vector<std::array<double, 6>>;

/// Reads a text dump whose columns are the id and `columns` numbers of each of `count` atoms. Throws Error where it is not whole.
DumpedAtoms read_dump(const std::string& path, std::size_t count, std::size_t columns);

/// Puts particles and bodies where LAMMPS has them, with its velocities, at `time` [s]. Throws Error.
void bring_back(World& world, const LammpsSystem& system, DumpedAtoms atoms, double time);

}  // namespace pantin::player
