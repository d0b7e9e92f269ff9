#pragma once
// What a shape is made from, as tables of Lua.
#include <string>
#include <vector>

#include "lua/thing/shape_type.hpp"
#include "lua/value/arguments.hpp"

namespace pantin::lua {

/// One of the ways to say a shape.
struct ShapeKind {
  const char* name;                                  ///< "box"
  std::vector<std::string> sizes;                    ///< names of the options that say how large it is
  std::vector<const char*> by_position;              ///< those that may be given by position
  void (*read)(Script&, const Options&, ShapeDef&);  ///< the geometry, and where it is in the frame of the shape
};
const std::vector<ShapeKind>& shape_kinds();
const ShapeKind& shape_kind(std::string_view name);

/// density, friction, restitution, rolling, spinning, surface_velocity, layer, sensor
const std::vector<std::string>& material_options();
Material material_of(const Options& options);
/// `layer`, or empty.
std::string layer_option(const Options& options);

/// Of its sizes and its material alone.
ShapeValue shape_of_sizes(Script& script, const ShapeKind& kind, const Options& options);
/// Of all options of a shape at `index`; `what` begins messages.
ShapeValue shape_at(Script& script, const ShapeKind& kind, lua_State* state, int index);

/// `list` and each name of `more`.
std::vector<std::string> with_names(std::vector<std::string> list, const std::vector<std::string>& more);

}  // namespace pantin::lua
