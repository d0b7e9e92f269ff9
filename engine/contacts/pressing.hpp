#pragma once
#include <vector>

#include "contacts/passes.hpp"
#include "contacts/solve/island.hpp"

namespace pantin {

/// Impulses of contacts in half a step, should they go on to press as before [N s], [N m s]: by slots of bodies, then of points.
/// Before a drift half of the last step's, if that was no blow; after one those that kept things apart in it, as far as these are no blow. None where
/// nothing touches.
std::vector<BodyLoad> pressing_impulses(const Model& model, const Articulates& articulates, const Contacts& contacts,
                                        bool drifted);

}  // namespace pantin
