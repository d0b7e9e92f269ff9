#pragma once
#include <lua.hpp>
#include <string_view>

namespace pantin::lua {

/// Pushes what `tostring` gives for a value. Tables, functions and coroutines are numbered in the order in which they were
/// first shown, "table: 1": Lua's own addresses differ from run to run.
std::string_view push_text(lua_State* state, int index);

/// Pushes the table that gives the number of each thing that was shown; it keeps none of them alive.
void push_shown(lua_State* state);

/// Puts `tostring` and `print` into the globals.
void open_tostring(lua_State* state);

}  // namespace pantin::lua
