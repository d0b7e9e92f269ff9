#pragma once
// A state in a file may have been made on purpose. Before anything in it is used, what is an index leads to something, and
// lists are as long as what they are of.
#include "snapshot/archive.hpp"
#include "world/world.hpp"

namespace pantin {

/// Throw Error where a state contradicts itself.
void check_read(const Reader& from, const World& world);
void check_read(const Forces& forces, const World& world);

}  // namespace pantin
