#pragma once
// scene:weld, orient, align, motor and limit.
#include <lua.hpp>

namespace pantin::lua {

int scene_weld(lua_State* state);
int scene_orient(lua_State* state);
int scene_align(lua_State* state);
int scene_motor(lua_State* state);
int scene_limit(lua_State* state);

}  // namespace pantin::lua
