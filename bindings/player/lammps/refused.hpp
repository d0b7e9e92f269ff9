#pragma once
#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace pantin::player {

/// What of a scene LAMMPS has not, or not by this program, up to a time [s]: a sentence each, with what to do; empty: nothing.
std::vector<std::string> refused_by_lammps(const Scene& scene, double until);

/// How messages call a force element: "scene.lua:12: lennard_jones".
std::string place_of(const ForceElement& element);

}  // namespace pantin::player
