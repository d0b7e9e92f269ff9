#pragma once
// What an emitter is made with.
#include <lua.hpp>
#include <string>
#include <utility>

#include "edit/emitter.hpp"
#include "lua/value/arguments.hpp"

namespace pantin::lua {

/// A vec, a box { vec, vec }, a point or a particle.
EmitterPosition check_emitter_position(lua_State* state, int index, const std::string& what);
/// A number or { min, max } [s].
std::pair<double, double> check_lifetimes(lua_State* state, int index, const std::string& what);
/// A function of time [s] that gives the rate [1/s].
std::function<double(double)> rate_function(const Callback& function);

/// `scene:emitter{ at, rate, … }`.
int scene_emitter(lua_State* state);

}  // namespace pantin::lua
