#pragma once
// Ties of an island alone, contacts as they are: a linear problem.
#include "contacts/solve/island.hpp"

namespace pantin {

/// Of ties in the matrices of an island, of 1 / w: a tie that is solved for once moves by its inverse of what it should forbid.
constexpr double tie_stiffness = 1e7;
inline double stiffness_of(const IslandTie& t) { return 1.0 / (t.w / tie_stiffness + t.softness); }

/// Adds the impulses with which ties answer the velocities v, w of the bodies; what these do to the bodies is left in `loads`.
/// Prepares the island's matrix of ties where that was not done.
void answer_of_ties(ContactIsland& island, std::vector<BodyLoad>& loads);

/// [J] What ends that move, motors and couplings give by these impulses.
double work_of_ties(const ContactIsland& island);
/// Ties want what they want without turning.
void forget_turning(ContactIsland& island);
/// Undoes `hold_ties` in ties and scalars: v0, w0 are set by the caller.
void forget_held(ContactIsland& island);
/// Lets ties answer v0, w0, which become the velocities that contacts begin with; the impulses are added to
/// `earlier_impulse` of ties and scalars. What contacts then give or take is held against velocities that ties allow.
void hold_ties(ContactIsland& island);

}  // namespace pantin
