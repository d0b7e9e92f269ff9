#pragma once

namespace pantin {

struct World;

/// Before a step: things that are near each other and fast for their size are moved in up to four sub-steps.
void divide_for_contacts(World& world);

}  // namespace pantin
