#pragma once
// Momentum and angular momentum of an articulate that nothing ties to the world. Forces of a row at a distance act at two
// positions and turn it, and closing a gap moves masses; what that changed is given back as a rigid motion, which every row
// leaves free.
#include "articulates/articulate.hpp"

namespace pantin {

struct Momenta {
  Vec3 p = zero3();        ///< [kg m/s]
  Vec3 angular = zero3();  ///< [kg m²/s] about the centre of mass
  double energy = 0.0;     ///< [J] of the motion that had them
};

/// Whether no row ties it to the world.
bool is_free(const Articulate& articulate);
/// Whether it is free and has rows whose two points are apart, so that their forces act at a distance, in each step.
inline bool acts_at_distance(const Articulate& a) { return a.attracts || (a.has_offsets && is_free(a)); }
Vec3 centre_of_mass(const Articulate& articulate);
/// Adds the inertia of a node's start about a position [kg m²]; of spin that nothing couples to nothing.
inline void add_locked_inertia(Mat3& sum, const Node& n, Vec3 X) {
  const Vec3 d = n.x0 - X;
  sum += (identity33() * norm2(d) - outer(d, d)) * n.mass;
  if (n.turns) sum += congruent(n.R0, n.inertia * n.felt_axes);
}
Momenta momenta_of(const Articulate& articulate);
/// What the rows' forces of a step of h [s], acting at a distance, did to the angular momentum [kg m²/s].
Vec3 angular_momentum_at_distance(const Articulate& articulate, double h);
/// The spin about X that makes up for angular momentum, about each principal axis that takes no more than `most` [J] to turn it.
Vec3 spin_for(const Articulate& articulate, Vec3 X, Vec3 angular, double most);
/// Gives it these momenta again. Points that all come to one position have nothing to turn; what would take more energy than
/// all the motion has, or had, stays lost. Returns the energy that this gave [J].
double restore_momenta(Articulate& articulate, const Momenta& wanted);

}  // namespace pantin
