#pragma once
#include "contacts/passes.hpp"

namespace pantin {

/// Takes the impulses of `place` back, and what ties answered to them, once the drift is over. Reports the change of the kinetic
/// energy by contacts [J], adds that of each thing to `placing_work`, and takes the work of ties back.
void take_back(TouchSpace& space, Workers& workers, Model& model, const Articulates& articulates, Contacts& contacts,
               const TouchSettings& settings, TouchReport& report);

}  // namespace pantin
