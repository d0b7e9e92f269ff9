#pragma once
#include <lua.hpp>

namespace pantin::lua {

/// Puts `expect` into the globals.
void open_expect(lua_State* state);

}  // namespace pantin::lua
