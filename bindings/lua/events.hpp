#pragma once
// Choreography, callbacks and play of a scene.
#include <lua.hpp>

namespace pantin::lua {

int scene_at(lua_State* state);
int scene_after(lua_State* state);
int scene_every(lua_State* state);
int scene_on(lua_State* state);
int scene_button(lua_State* state);
int scene_probe(lua_State* state);
int scene_hand(lua_State* state);

}  // namespace pantin::lua
