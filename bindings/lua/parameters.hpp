#pragma once
#include <lua.hpp>

namespace pantin::lua {

/// scene:param(name, default, { min, max, step, help, choices, on_change })
int scene_param(lua_State* state);

}  // namespace pantin::lua
