#pragma once
// The fields of a thing as the tables of the bindings have them, for whoever shows or edits them.
#include <string>
#include <variant>
#include <vector>

#include "scene/scene.hpp"

namespace pantin::lua {

/// A field of a thing and what it is now. Only numbers, booleans, strings and vecs can be written.
struct FieldReading {
  const char* name;
  const char* unit;  ///< "" where there is none
  const char* doc;
  bool writable = false;
  std::variant<std::monostate, double, bool, std::string, Vec3> value;  ///< monostate: nothing, or a thing
  AnyId thing;                                                          ///< where the value is a thing
};

/// Of a point, particle, body, constraint, connection …; those with lists and tables are left out. Empty for what is gone.
std::vector<FieldReading> read_fields(Scene& scene, const AnyId& thing);
/// Writes one as a script would, between two steps; throws what a script would be told.
void write_field(Scene& scene, const AnyId& thing, const std::string& name, const FieldReading& value);

}  // namespace pantin::lua
