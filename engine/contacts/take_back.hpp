#pragma once
#include "contacts/stages.hpp"

namespace pantin {

/// Takes the impulses of `place` back, once the drift is over. Returns the change of the kinetic energy [J],
/// and adds that of each thing, by number_of.
double take_back(Model& model, const Articulates& articulates, Contacts& contacts, bool drifted,
                 std::vector<double>& placing_work);

}  // namespace pantin
