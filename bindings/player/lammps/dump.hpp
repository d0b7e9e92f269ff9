#pragma once
// What LAMMPS wrote of its atoms, and how it comes back into the scene.
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "player/lammps/system.hpp"

namespace pantin::player {

/// Of each atom six numbers, by its number less 1: position [m], not wrapped into the box, and velocity [m/s].
using DumpedAtoms = std::vector<std::array<double, 6>>;

struct LammpsState {
  double step = 0.0;  ///< LAMMPS' count of steps
  DumpedAtoms atoms;
};

/// (atoms) [N] of a text dump with the columns id, fx, fy, fz. Throws Error where it is not whole.
std::vector<Vec3> read_forces(const std::string& path, std::size_t count);
/// The last whole picture of a text dump, with columns in any order: id, vx, vy, vz, and xu, yu, zu, or x, y, z with ix, iy, iz
/// (without them where nothing is periodic). Throws Error where there is none, or it is not of these atoms or of this box [m], where there is one.
LammpsState read_state(const std::string& path, const LammpsSystem& system, const std::optional<Vec3>& box);

/// Puts particles and bodies where LAMMPS has them, with its velocities, at `time` [s]. Throws Error.
void bring_back(World& world, const LammpsSystem& system, DumpedAtoms atoms, double time);

}  // namespace pantin::player
