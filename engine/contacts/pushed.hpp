#pragma once
#include "contacts/find.hpp"
#include "contacts/gather.hpp"

namespace pantin {

/// Contacts know how fast things were, not what blows make of that: adds those with what bodies meet whom the velocities of
/// these islands take farther in the coming drift than their margins reach, and with what these push in turn. Whether there are
/// any.
bool find_pushed(const ThingsNow& where, ContactFinder& finder, std::span<const TouchIsland> islands,
                 Contacts& contacts);

}  // namespace pantin
