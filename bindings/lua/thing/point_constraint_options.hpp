#pragma once
// scene:hinge, nail, follow and rod.
#include <functional>
#include <lua.hpp>
#include <string>

#include "lua/value/callback.hpp"

namespace pantin::lua {

/// A script's function of time [s] that returns a place [m].
std::function<Vec3(double)> position_of_time(Callback function, std::string what);

int scene_hinge(lua_State* state);
int scene_nail(lua_State* state);
int scene_follow(lua_State* state);
int scene_rod(lua_State* state);

}  // namespace pantin::lua
