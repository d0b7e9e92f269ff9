#pragma once
// Shapes of bodies and of the world, as options.
#include <lua.hpp>
#include <vector>

#include "edit/edit.hpp"
#include "lua/thing/shape_type.hpp"
#include "lua/value/arguments.hpp"

namespace pantin::lua {

struct Script;

/// `shape`, or the list `shapes`; those without a colour, a picture or a layer have that of the options, those without any
/// colour `usual` or, with a picture, white.
std::vector<ShapeValue> shape_options(Script& script, const Options& options, const Color& usual);
/// The colour of the options, else `usual` or, of what has a picture, white.
Color color_option(const Options& options, const std::shared_ptr<const Cover>& cover, const Color& usual);
/// Throws Error where a table at `index` has what only its shapes have.
void refuse_material(lua_State* state, int index, const std::string& what);
/// What to do with what shall move.
extern const char* const stands_still;
/// `{ height, normal, friction, restitution, rolling, spinning, surface_velocity, layer, sensor, size, color, picture, name }`.
ShapeDef floor_def(Script& script, lua_State* state, int index);
/// `{ shape, shapes, at, orientation, color, picture, layer }`.
std::vector<ShapeDef> ground_defs(Script& script, lua_State* state, int index);

}  // namespace pantin::lua
