#include "lua/thing/look_options.hpp"

#include "fields/look.hpp"
#include "lua/law/curve_options.hpp"

namespace pantin::lua {
namespace {

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
  if (const auto name = options.string("look")) looks.look = fields::look_of_name(*name, options.what());
  return looks;
}

}  // namespace pantin::lua
