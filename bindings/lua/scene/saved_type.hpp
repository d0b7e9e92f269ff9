#pragma once
#include <lua.hpp>

#include "scene/options.hpp"

namespace pantin::lua {

/// What a scene's `scene.saved` begins with: a table at argument 3, or that of another scene, which both have from then on.
void give_saved(lua_State* state, int index, const char* call, SceneOptions& options);

}  // namespace pantin::lua
