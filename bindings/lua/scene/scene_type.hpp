#pragma once
#include <lua.hpp>

#include "lua/thing/script.hpp"

namespace pantin::lua {

/// Puts `scene` and `structure` into the globals.
void open_globals(lua_State* state, Script& script);
/// Pushes `scene.store`.
void push_store(lua_State* state, Script& script);

}  // namespace pantin::lua
