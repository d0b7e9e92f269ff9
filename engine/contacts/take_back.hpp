#pragma once
#include "contacts/stages.hpp"

namespace pantin {

/// Takes the impulses of `place` back, and what ties answered to them, once the drift is over. Returns the change of the kinetic
/// energy by contacts [J], and adds that of each thing to `placing_work`.
double take_back(TouchSpace& space, Model& model, const Articulates& articulates, Contacts& contacts,
                 const TouchSettings& settings);

}  // namespace pantin
