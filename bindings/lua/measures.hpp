#pragma once
// Numbers about the whole scene or a group, as Lua reads them.
#include <lua.hpp>

#include "lua/fields.hpp"

namespace pantin::lua {

/// energy, momentum, angular_momentum, temperature of the things of a group.
std::vector<Field> thing_measures();
/// time, energy, momentum, angular_momentum, temperature, error, stats, log and the lists of things of a scene.
std::vector<Field> scene_measures();
int scene_find(lua_State* state);
int scene_near(lua_State* state);

}  // namespace pantin::lua
