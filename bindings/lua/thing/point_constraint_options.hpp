#pragma once
// scene:hinge, and functions of time that give a position.
#include <functional>
#include <lua.hpp>
#include <string>

#include "lua/value/callback.hpp"

namespace pantin::lua {

/// A script's function of time [s] that returns a place [m].
std::function<Vec3(double)> position_of_time(Callback function, std::string what);

int scene_hinge(lua_State* state);

}  // namespace pantin::lua
