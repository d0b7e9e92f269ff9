#pragma once
// Callbacks and play of a scene.
#include <lua.hpp>

namespace pantin::lua {

int scene_on(lua_State* state);
int scene_behave(lua_State* state);
int scene_button(lua_State* state);
int scene_probe(lua_State* state);
int scene_hand(lua_State* state);

}  // namespace pantin::lua
