#pragma once
#include <lua.hpp>

namespace pantin::lua {

int scene_gear(lua_State* state);    ///< scene:gear(a, b, { ratio, axis, axis_b, carrier })
int scene_rack(lua_State* state);    ///< scene:rack(wheel, point, { radius, axis, along, carrier })
int scene_pulley(lua_State* state);  ///< scene:pulley(a, over_a, over_b, b, { ratio, length })
int scene_screw(lua_State* state);   ///< scene:screw(a, b, { lead, axis })

}  // namespace pantin::lua
