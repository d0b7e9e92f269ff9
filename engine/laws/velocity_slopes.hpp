#pragma once
// How the forces of laws change with velocities: what an implicit kick asks of them.
#include <memory>

#include "laws/law.hpp"

namespace pantin {

/// The same law whose outputs are followed by their derivatives: of a central law, by the approach; else those of each
/// component of the force by x, then y, then z of the velocity (of b relative to a). A called law stays as it is: its
/// derivatives are differences.
std::shared_ptr<const Law> with_velocity_slopes(const Law& law);
/// Whether the force of a law is linear in velocities, and leaps nowhere; takes what `with_velocity_slopes` made.
bool is_linear_in_velocity(const Law& sloped);
/// Whether what velocities add to the force does no work, as v × B: looked at in samples. False of a called law.
bool is_workless(const Law& law);

}  // namespace pantin
