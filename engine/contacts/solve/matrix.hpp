#pragma once
// The matrix of an island's velocities, M + Σ G' D G + Σ T' k T, factorised by body.
#include <span>

#include "contacts/solve/island.hpp"

namespace pantin {

/// Sets the part of masses and ties, with stiffness `tie_stiffness` / w of each tie [kg]. Lays out the factor first, where
/// that is still to be done: what is solved where its search begins needs none.
void set_base(ContactIsland& island, double tie_stiffness);
/// Factorises the base with the contacts' stiffness: D(contact) [kg], world axes, by index; none where it is off.
void factorise(ContactIsland& island, std::span<const Mat3> stiffness);
/// Solves for the change of velocities [m/s], [rad/s] that these make.
void solve(ContactIsland& island, std::span<const BodyLoad> load, std::span<BodyLoad> change);

}  // namespace pantin
