#pragma once
// Contacts that were foreseen before blows at the end of the last step.
#include "contacts/find.hpp"

namespace pantin {

/// Finds those of pairs that rebound anew of which one goes on otherwise than was foreseen, where they strike or were to. Before
/// the drift.
void foresee_anew(const ThingsNow& where, ContactFinder& finder, Contacts& contacts);

}  // namespace pantin
