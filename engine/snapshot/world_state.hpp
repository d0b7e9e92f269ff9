#pragma once
// A world's state as bytes: all that a snapshot holds, so that a world that reads it goes on to the same bits. Only the same
// version of the program reads it, see `layout_of_state`.
#include <cstdint>

#include "snapshot/archive.hpp"

namespace pantin {

/// Between two steps. Throws Error where functions are in it that nobody can keep.
void visit_world(Writer& to, World& world);
/// Into a world, whatever was in it; threads, callbacks and the profile stay as they are. Throws Error where the bytes are no
/// state; the world is of no use then.
void visit_world(Reader& from, World& world);

/// A law, which may also be part of the world.
void visit_law(Writer& to, std::shared_ptr<const Law>& law);
void visit_law(Reader& from, std::shared_ptr<const Law>& law);

/// Another number where what makes up a state has another form.
std::uint64_t layout_of_state();

}  // namespace pantin
