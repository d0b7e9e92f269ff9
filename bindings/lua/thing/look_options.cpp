#include "lua/thing/look_options.hpp"

#include <algorithm>
#include <iterator>

#include "lua/law/curve_options.hpp"

namespace pantin::lua {
namespace {

const char* const names[] = {"ball", "glow", "streak"};

/// Puts the function that an option is given as into the curves, or returns false.
bool read_curve(lua_State* state, const Options& options, const std::string& name, Looks& looks) {
  const int at = options.push(name.c_str());
  const bool is_function = lua_isfunction(state, at);
  if (is_function) looks.curves = with(looks.curves.get(), curve_of(state, at, options.what(), name));
  lua_pop(state, 1);
  return is_function;
}

}  // namespace

Looks look_options(const Options& options, const std::vector<std::string>& attributes) {
  lua_State* state = options.state();
  Looks looks;
  if (!read_curve(state, options, "color", looks)) looks.color = options.color("color");
  if (!read_curve(state, options, "radius", looks)) looks.radius = options.number("radius", "m");
  for (const std::string& name : attributes) {
    if (read_curve(state, options, name, looks)) continue;
    if (const auto value = options.number(name.c_str(), "")) looks.attributes.push_back({name, *value});
  }
  if (options.has("look")) {
    looks.look = check_look(state, options.push("look"), options.what());
    lua_pop(state, 1);
  }
  return looks;
}

Look check_look(lua_State* state, int index, const std::string& what) {
  const std::string name = check_text(state, index, what, "look");
  const auto found = std::find(std::begin(names), std::end(names), name);
  require(found != std::end(names), what, ": look must be \"ball\", \"glow\" or \"streak\", got \"", name, "\"");
  return static_cast<Look>(found - std::begin(names));
}

const char* name_of(Look look) { return names[static_cast<std::size_t>(look)]; }

}  // namespace pantin::lua
