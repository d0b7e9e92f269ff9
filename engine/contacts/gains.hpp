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
/// Takes back, by slowing them down, what those got that missed the law, rub on the world, are not tied and do not rebound.
Gains settle_gains(Model& model, const Articulates& articulates, std::span<const TouchIsland> placed,
                   std::span<const TouchIsland> met, std::span<const WorkOnThing> beside, bool drifted);

}  // namespace pantin
