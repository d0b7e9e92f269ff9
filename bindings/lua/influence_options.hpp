#pragma once
// scene:connect, interact and field.
#include <lua.hpp>

namespace pantin::lua {

int scene_connect(lua_State* state);
int scene_interact(lua_State* state);
int scene_field(lua_State* state);

}  // namespace pantin::lua
