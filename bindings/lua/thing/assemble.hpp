#pragma once
// Things made of others.
#include <lua.hpp>

namespace pantin::lua {

int scene_merge(lua_State* state);
int scene_split(lua_State* state);
int scene_freeze(lua_State* state);
int scene_shatter(lua_State* state);
int scene_connect_within(lua_State* state);
int group_break_connections(lua_State* state);
int group_heat(lua_State* state);

}  // namespace pantin::lua
