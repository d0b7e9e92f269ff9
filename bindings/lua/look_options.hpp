#pragma once
// How particles look and what of them follows their age: options that families, particles and emitters share.
#include <lua.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "laws/course.hpp"
#include "lua/arguments.hpp"
#include "world/edit.hpp"

namespace pantin::lua {

/// `color`, `radius`, `look` and attributes; the first two and the last may be functions of (age, life) [s].
struct Looks {
  std::optional<Color> color;
  std::optional<double> radius;  ///< [m]
  std::optional<Look> look;
  std::vector<AttributeDef> attributes;
  std::shared_ptr<const Courses> courses;  ///< null: none
};
Looks look_options(const Options& options, const std::vector<std::string>& attributes);

/// "ball", "glow" or "streak".
Look check_look(lua_State* state, int index, const std::string& what);
const char* name_of(Look look);

}  // namespace pantin::lua
