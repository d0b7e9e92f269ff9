#pragma once
// The state of a scene in a file: the world, what the script declared, and all that it has in Lua's memory, with its text
// and the files that it read. A scene that is opened from it goes on to the same bits.
#include <memory>
#include <string>

#include "lua/thing/script.hpp"
#include "scene/scene.hpp"

namespace pantin::lua {

/// Between two steps. Throws Error where something cannot be kept: a play that waits, a coroutine.
std::string state_of(Script& script);
/// Saves the state as a callback asked for, if one did.
void save_wanted(Script& script);

}  // namespace pantin::lua
