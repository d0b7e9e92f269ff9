#pragma once
#include <lua.hpp>

namespace pantin::lua {

/// `scene:build(structure, options)`: a group.
int scene_build(lua_State* state);

}  // namespace pantin::lua
