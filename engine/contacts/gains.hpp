#pragma once
#include <utility>
#include <vector>

#include "contacts/gather.hpp"

namespace pantin {

/// Work on one thing, by its number_of [J].
using WorkOnThing = std::pair<std::size_t, double>;

/// What contacts gave in a pass that they should not: friction and impact only take, but for what belts give, each in what was
/// joined before the drift, after it, or by both. Nothing that one takes hides what another gives.
struct Gains {
  double wrong = 0.0;       ///< [J] of all
  double taken_back = 0.0;  ///< [J] of that
};
/// Takes back what those got that are not tied, and missed the law, rub on the world and do not rebound, or got a large part of
/// what they have, and would have that fell for a step, `fallen` [m/s] by then: by slowing them down, against the world if they rub on it, else against their motion as one.
Gains settle_gains(Model& model, const Articulates& articulates, std::span<const TouchIsland> placed,
                   std::span<const TouchIsland> met, std::span<const WorkOnThing> beside, double fallen, bool drifted);

}  // namespace pantin
