#pragma once
// Callbacks and play of a scene.
#include <lua.hpp>

#include "lua/thing/script.hpp"

namespace pantin::lua {

/// The name of a key, or with "pad." of what a gamepad has, as the world knows it; throws Error where there is none.
std::string check_control(const std::string& name);
/// The same for a key that is pressed, which may be "ctrl+z" or "ctrl+shift+z".
std::string check_key(const std::string& name);

/// Tells the callbacks of the script what happened in the last step, and that a step begins.
void run_behaviours(Script& script);
/// Puts a function or a behaviour among those that wait, and pushes its Subscription; returns 1.
int subscribe(lua_State* state, Script& script, Subscription subscription);

int scene_on(lua_State* state);
int scene_behave(lua_State* state);
/// The built-in function that is a behaviour's part: its upvalues are the behaviour at work and the part's name.
lua_CFunction behaviour_part();
int scene_button(lua_State* state);
int scene_probe(lua_State* state);
int scene_hand(lua_State* state);

}  // namespace pantin::lua
