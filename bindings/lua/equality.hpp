#pragma once
#include <lua.hpp>
#include <string>

namespace pantin::lua {

/// "scene.lua:12: …" where the function at `index`, or one written inside of it, tests two values or a value and a number
/// for equality; else empty. Such a test is silently false of a symbol and a number, and Lua tells nobody.
std::string equality_test(lua_State* state, int index);

}  // namespace pantin::lua
