#pragma once
#include <lua.hpp>

namespace pantin::lua {

/// `scene.box` is the edges of the periodic box, a vec or nil, and `scene:box { … }` makes a body: this lets the value that is
/// read there be called by that name. What else is called without being a function is an error, as ever.
void let_box_be_called(lua_State* state, lua_CFunction make_box);

}  // namespace pantin::lua
