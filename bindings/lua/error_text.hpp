#pragma once
#include <lua.hpp>
#include <string>

namespace pantin::lua {

/// Message handler of protected calls: makes of any error a text that begins with a script's file and line.
int describe_error(lua_State* state);

/// Whether a message begins with a file and line, "scene.lua:12: ".
bool names_place(const std::string& message);

}  // namespace pantin::lua
