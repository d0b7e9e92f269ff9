#pragma once
// Shapes of bodies and of the world, as options.
#include <lua.hpp>
#include <vector>

#include "edit/edit.hpp"
#include "lua/thing/shape_type.hpp"
#include "lua/value/arguments.hpp"

namespace pantin::lua {

struct Script;

/// `shape`, or the list `shapes`; those without a colour have this one, those without a layer that of the options.
std::vector<ShapeValue> shape_options(const Options& options, const Color& color);
/// Throws Error where a table at `index` has what only its shapes have.
void refuse_material(lua_State* state, int index, const std::string& what);
/// What to do with what shall move.
extern const char* const stands_still;
/// `{ height, normal, friction, restitution, rolling, spinning, surface_velocity, layer, sensor, size, color, name }`.
ShapeDef floor_def(Script& script, lua_State* state, int index);
/// `{ shape, shapes, at, orientation, color, layer }`.
std::vector<ShapeDef> ground_defs(lua_State* state, int index);

}  // namespace pantin::lua
