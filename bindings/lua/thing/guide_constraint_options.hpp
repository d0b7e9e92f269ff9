#pragma once
// scene:on_plane, string and on_path.
#include <lua.hpp>

namespace pantin::lua {

int scene_on_plane(lua_State* state);
int scene_string(lua_State* state);
int scene_on_path(lua_State* state);

}  // namespace pantin::lua
