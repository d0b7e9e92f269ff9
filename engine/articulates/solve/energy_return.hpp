#pragma once
#include "articulates/articulate.hpp"

namespace pantin {

/// Makes the kinetic energy `kinetic` again [J], as far as speeds 1.2 times as large do; nothing is given back where
/// something else than gravity may do work: where an anchor moves, a motor, a law or a soft row acts, something touches or was
/// struck, and after a fallback step. Returns what it gave [J].
double return_energy(Articulate& articulate, double kinetic, Vec3 gravity);

/// Scales the motion relative to the rigid motion that the anchors leave free, by `most` at most, to change the kinetic
/// energy by `change` [J]. Spin that nothing couples to stays as it is. Returns by how much it changed [J].
double change_kinetic_energy(Articulate& articulate, double change, double most, Vec3 gravity);

}  // namespace pantin
