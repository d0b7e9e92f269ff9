#pragma once
// The matrix of an island's velocities, M + Σ G' D G + Σ T' k T, factorised by body.
#include <span>

#include "contacts/solve/island.hpp"

namespace pantin {

/// Lays out the factor, where that is still to be done: of all that ties bodies, or of ties alone. The first says false, and
/// lays out nothing, where a factorisation would update more than so many blocks.
bool lay_out_all(ContactIsland& island, std::size_t most_updates);
void lay_out_ties(ContactIsland& island);
/// Sets the part of masses and ties, with stiffness `tie_stiffness` / w of each tie [kg].
void set_base(ContactIsland& island, double tie_stiffness);
/// Factorises the base with stiffnesses in world axes, by index, or none at all: of contacts [kg], of rolls [kg m²].
void factorise(ContactIsland& island, std::span<const Mat3> stiffness, std::span<const Mat3> roll_stiffness);
/// Solves for the change of velocities [m/s], [rad/s] that these make.
void solve(ContactIsland& island, std::span<const BodyLoad> load, std::span<BodyLoad> change);

}  // namespace pantin
