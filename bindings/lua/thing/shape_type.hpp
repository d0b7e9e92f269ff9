#pragma once
// Shapes as values of Lua: what `shape.box{ … }` and the others return.
#include <lua.hpp>
#include <optional>
#include <vector>

#include "edit/edit.hpp"
#include "lua/thing/fields.hpp"

namespace pantin::lua {

struct ShapeValue {
  const char* kind;            ///< "box"
  ShapeDef def;                ///< in the frame of the body, or of the world
  std::optional<Color> color;  ///< if it was given one
  bool density_given = false;
};

void push_shape(lua_State* state, Script& script, ShapeValue value);
/// Throws Error, beginning with `what`, where the value is no shape.
const ShapeValue& check_shape_value(lua_State* state, int index, std::string_view what, std::string_view name);

/// The functions of the table `shape`; upvalue 1 of each: the script.
const std::vector<Method>& shape_makers();
/// Puts the table `shape` into the globals.
void open_shapes(lua_State* state, Script& script);

}  // namespace pantin::lua
