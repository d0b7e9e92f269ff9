#pragma once
// Connections that are solved with their articulates: which, and what their laws read. Not for use outside world/.
#include "forces/forces.hpp"

namespace pantin {

/// Whether a connection can be solved: of two ends, by a law that can be told along a single pair, in open space.
bool can_be_solved(const World& world, const Connection& connection);
/// Says of each connection what it does, from what was asked, the integrator and what was found too stiff; after edits.
void choose_solved(World& world);
/// Gives the laws of solved connections their parameters, attributes and time: after edits, and where these change by
/// themselves (`only_changing`).
void set_solved_inputs(World& world, bool only_changing);
/// Finds explicit connections that are too stiff for the length of the step, from the positions that the sites now have:
/// with the sum over an end's connections of h² stiffness / mass, and the turning of its body, both ends together may
/// reach 0.01 on articulates, whose velocities are projected, and 2.5 elsewhere (4 is where verlet begins to diverge).
/// Tells the log once of each law. Returns whether there are any.
bool find_too_stiff(World& world, Forces& forces);

}  // namespace pantin
