#pragma once
// scene:weld, orient, align, motor, limit, on_plane, string and on_path.
#include <lua.hpp>

namespace pantin::lua {

int scene_weld(lua_State* state);
int scene_orient(lua_State* state);
int scene_align(lua_State* state);
int scene_motor(lua_State* state);
int scene_limit(lua_State* state);
int scene_on_plane(lua_State* state);
int scene_string(lua_State* state);
int scene_on_path(lua_State* state);

}  // namespace pantin::lua
