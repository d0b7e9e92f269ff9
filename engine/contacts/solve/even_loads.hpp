#pragma once
#include "contacts/solve/island.hpp"

namespace pantin {

/// Of what is solved exactly anyway, and where nothing heavy makes much of what is left of that.
bool has_even_loads(const ContactIsland& island);

/// Where bodies hold each other in more ways than one, the law leaves open how loads are shared: those of least Σ w γ² are taken
/// of what does the same to all bodies, whatever the search found, began with, or had found before. Nothing changes where none
/// of those that bear could then bear. The factor is laid out for all.
void even_loads(ContactIsland& island);

}  // namespace pantin
