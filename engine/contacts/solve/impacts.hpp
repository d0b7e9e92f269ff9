#pragma once
#include "contacts/solve/island.hpp"

namespace pantin {

/// What impacts did: their impulses are in `impact_impulse` of contacts and `earlier_impulse` of ties and scalars.
struct ImpactReport {
  std::uint32_t rounds = 0, iterations = 0;
};

/// Impacts of an island run through it in rounds (Newton's law of impact, after Routh's order): contacts that near each other
/// faster than `slow` [m/s] strike at once, others do not exist; what that sets moving strikes in the next round. Ties hold all
/// the while. Velocities without impulses (v0, w0) are those after it. Contacts say `restitution` and `rebound`; bias is of belts
/// alone. `done_before` [J] is what contacts did before: rounds that would add to it from nowhere, or leave it, rebound less.
/// `lifted` [J] is what the first round has to take of the motion against each other, for bodies are higher than they would be
/// without what contacts did.
ImpactReport resolve_impacts(ContactIsland& island, double slow, double done_before, double lifted);

}  // namespace pantin
