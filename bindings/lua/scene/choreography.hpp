#pragma once
// Events of a scene.
#include <lua.hpp>
#include <string>

#include "choreography/choreography.hpp"
#include "lua/value/callback.hpp"

namespace pantin::lua {

struct Script;

int scene_at(lua_State* state);
int scene_after(lua_State* state);
int scene_every(lua_State* state);
int scene_over(lua_State* state);
int scene_when(lua_State* state);
int scene_play(lua_State* state);

/// The condition of a `when`: a function, or a table of what is measured, with the options at `options`.
Measured check_condition(lua_State* state, int index, int options, Script& script);
/// A function that is a script with waits, as the engine runs it.
std::function<std::optional<Wait>()> play_of(lua_State* state, int index, Script& script, AnyId target);

}  // namespace pantin::lua
