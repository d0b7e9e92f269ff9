#pragma once
// Ties of an island alone, contacts as they are: a linear problem.
#include "contacts/solve/island.hpp"

namespace pantin {

/// Of ties in the matrices of an island, of 1 / w: a tie that is solved for once moves by its inverse of what it should forbid.
constexpr double tie_stiffness = 1e7;

/// Adds the impulses with which ties answer the velocities v, w of the bodies; what these do to the bodies is left in `loads`.
/// Prepares the island's matrix of ties where that was not done.
void answer_of_ties(ContactIsland& island, std::vector<BodyLoad>& loads);

/// Lets ties answer v0, w0, which become the velocities that contacts begin with; the impulses go to `struck` of the ties. What
/// contacts then give or take is held against velocities that ties allow.
void hold_ties(ContactIsland& island);

}  // namespace pantin
