#pragma once
#include "contacts/solve/island.hpp"

namespace pantin {

/// What impacts did: beside `IslandContact::struck` and `IslandTie::struck`, which have their impulses.
struct ImpactReport {
  std::uint32_t rounds = 0, iterations = 0;
};

/// Impacts of an island run through it in rounds (Newton's law of impact, after Routh's order): contacts that near each other
/// faster than `slow` [m/s] strike at once, others do not exist; what that sets moving strikes in the next round. Ties hold all
/// the while. Velocities without impulses (v0, w0) are those after it. Contacts say `restitution` and `rebound`; bias is of belts
/// alone. `gained` [J] is what contacts did before: rounds that would add to it from nowhere, or leave it, rebound less.
ImpactReport resolve_impacts(ContactIsland& island, double slow, double gained);

}  // namespace pantin
