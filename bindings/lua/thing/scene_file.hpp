#pragma once
#include <cstddef>
#include <lua.hpp>
#include <string>

namespace pantin::lua {

/// All of a file below the scene's folder, or in a folder of `assets` that comes with the program. Throws Error, beginning
/// with `call`, where there is none, it lies elsewhere, or it has more than `largest` bytes.
std::string read_scene_file(lua_State* state, const std::string& call, const char* assets, const std::string& name,
                            std::size_t largest);

}  // namespace pantin::lua
