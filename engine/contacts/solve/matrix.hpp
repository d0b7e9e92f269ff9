#pragma once
// The matrix of an island's velocities, M + Σ G' D G + Σ T' k T, factorised by body.
#include <span>

#include "contacts/solve/island.hpp"

namespace pantin {

/// Lays out `all` or `ties_alone` for the pairs of an island, where they are others than before. The first says false, and lays out
/// nothing, where a factorisation would update more than so many blocks.
bool lay_out_all(ContactIsland& island, std::size_t most_updates);
void lay_out_ties(ContactIsland& island);
/// Sets the part of masses and ties.
void set_base(const ContactIsland& island, Layout& layout);
/// Factorises the base with stiffnesses in world axes, by index, or none at all: of contacts [kg], of rolls [kg m²], of scalars
/// within bounds [kg]. Where these are symmetric that takes some half of the time.
void factorise(const ContactIsland& island, Layout& layout, std::span<const Mat3> stiffness,
               std::span<const Mat3> roll_stiffness, std::span<const double> scalar_stiffness, bool symmetric);
/// Solves for the change of velocities [m/s], [rad/s] that these make.
void solve(const ContactIsland& island, Layout& layout, std::span<const BodyLoad> load, std::span<BodyLoad> change);

}  // namespace pantin
