#pragma once
// Families and attributes in the options of what has particles.
#include <lua.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "edit/edit.hpp"
#include "lua/value/arguments.hpp"

namespace pantin::lua {

/// The `family` of an options table at `index`, or null, with the names of its attributes.
struct FamilyOption {
  FamilyId id;
  std::vector<std::string> attributes;
};
/// Reads it, and adds its attributes to the names of known options, which live as long as it.
FamilyOption family_option(lua_State* state, int index, const std::string& what, std::vector<std::string_view>& known);

/// The attributes that were given, as numbers.
std::vector<AttributeDef> attribute_options(const Options& options, const std::vector<std::string>& attributes);

/// `scene:family(name, { attributes, color, radius, mass, look })`.
int scene_family(lua_State* state);

}  // namespace pantin::lua
