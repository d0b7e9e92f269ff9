#pragma once
#include <lua.hpp>
#include <string>

namespace pantin::lua {

/// Message handler of protected calls: makes of any error a text that begins with a script's file and line.
int describe_error(lua_State* state);

/// The text of the error value at `index`; `place` is where it was raised, for one that does not say.
std::string error_message(lua_State* state, int index, const std::string& place);

}  // namespace pantin::lua
