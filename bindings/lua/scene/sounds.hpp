#pragma once
// What a script lets be heard.
#include <lua.hpp>
#include <string>

#include "lua/thing/script.hpp"

namespace pantin::lua {

/// `ScriptData::contact_sounds`: each as its density says.
inline constexpr const char* by_material = "by material";

/// The name of a sound, or the path of a file below the scene's folder.
std::string check_sound(lua_State* state, int index, const char* call, const char* name);
int scene_sound(lua_State* state);
/// Lets be heard what touched, where the script wants that.
void sound_touch(Script& script, const Touch& touch);

}  // namespace pantin::lua
