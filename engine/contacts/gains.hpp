#pragma once
#include <utility>
#include <vector>

#include "contacts/gather.hpp"

namespace pantin {

/// Work on one thing, by its number_of [J].
using WorkOnThing = std::pair<std::size_t, double>;

/// [J] What contacts gave in a pass that they should not: friction and impact only take, but for what belts give, each in what
/// was joined before the drift, after it, or by both. Nothing that one takes hides what another gives.
double gains(const Model& model, std::span<const TouchIsland> placed, std::span<const TouchIsland> met,
             std::span<const WorkOnThing> beside);

}  // namespace pantin
