#pragma once
// Functions of (age, life) that a particle's color, radius or attribute follows.
#include <lua.hpp>
#include <memory>
#include <string>

#include "laws/curve.hpp"

namespace pantin::lua {

/// Traces the function at `index`, of age and life [s], which gives a number, or for "color" a color: "#rrggbb" or
/// { r, g, b, a }. It runs now, on symbols, and never again. Throws Error where it cannot be traced.
std::shared_ptr<const Curve> curve_of(lua_State* state, int index, const std::string& what, const std::string& name);

}  // namespace pantin::lua
