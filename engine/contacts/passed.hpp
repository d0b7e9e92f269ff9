#pragma once
// What a drift took through something all the same: a blow that none foresaw may send a body anywhere.
#include "contacts/find.hpp"

namespace pantin {

/// Puts bodies that nothing ties, and that went through another shape in the drift, back to where the two met, each along its own
/// way: they keep their momenta, and to 1e-12 the angular momentum about any point. Returns the work against gravity [J].
double put_back_passed(const ThingsNow& where, ContactFinder& finder, Model& model, Contacts& contacts);

}  // namespace pantin
