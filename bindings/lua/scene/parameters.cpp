// Parameters of a scene, and settings from the command line.
#include "lua/scene/parameters.hpp"

#include <algorithm>
#include <cmath>

#include "lua/thing/fields.hpp"
#include "lua/thing/script.hpp"
#include "lua/value/arguments.hpp"
#include "lua/vm/guard.hpp"
#include "scene/parameter.hpp"

namespace pantin::lua {
namespace {

SceneValue check_value(lua_State* state, int index, const std::string& what, const std::string& name) {
  switch (lua_type(state, index)) {
    case LUA_TNUMBER: return check_number(state, index, what, name, "");
    case LUA_TBOOLEAN: return lua_toboolean(state, index) != 0;
    case LUA_TSTRING: return check_text(state, index, what, name);
    default: break;
  }
  throw Error(
      text(what, ": ", name, " must be a number, true or false, or a string, got ", kind_of_value(state, index)));
}

void read_choices(lua_State* state, const Options& o, SceneParameter& p) {
  const int list = o.push("choices");
  if (!lua_isnil(state, list)) {
    require(lua_istable(state, list), "param: choices must be a list, got ", kind_of_value(state, list));
    const auto count = lua_rawlen(state, list);
    require(count > 0, "param: choices must have at least one value, got none");
    for (lua_Unsigned i = 1; i <= count; i++) {
      lua_rawgeti(state, list, static_cast<lua_Integer>(i));
      p.choices.push_back(check_value(state, -1, "param", text("choice ", i)));
      lua_pop(state, 1);
    }
  }
  lua_pop(state, 1);
}

void push_parameter(lua_State* state, const SceneParameter& p) {
  const auto* number = std::get_if<double>(&p.value);
  if (number && p.integer && std::fabs(*number) < 0x1p53 && std::trunc(*number) == *number)
    lua_pushinteger(state, static_cast<lua_Integer>(*number));
  else
    push_value(state, p.value);
}

void take_command_line(const Script& script, SceneParameter& p) {
  const auto given = script.options.set.find(p.name);
  if (given == script.options.set.end()) return;
  try {
    const SceneValue value = value_of_text(p, given->second);
    check_allowed(p, value);
    p.value = value;
  } catch (const Error& error) {
    if (!script.options.forgiving)
      throw UsageError(text(script.options.set_by, p.name, "=", given->second, ": ", error.what()));
  }
}

/// Pushes what a text means for a setting: a number, true or false, "x,y,z" for a vec, nil where that may be, else the text.
void push_setting(lua_State* state, const Field& field, const std::string& given) {
  if (std::string_view(field.type) == "string") return void(lua_pushstring(state, unquoted(given).c_str()));
  if (const auto number = number_of_text(given)) {
    if (std::fabs(*number) < 0x1p53 && std::trunc(*number) == *number)
      return lua_pushinteger(state, static_cast<lua_Integer>(*number));
    return lua_pushnumber(state, *number);
  }
  if (given == "nil" && std::string_view(field.type).ends_with('?')) return lua_pushnil(state);
  if (given == "true" || given == "false") return lua_pushboolean(state, given == "true");
  const auto first = given.find(','), second = given.find(',', first + 1);
  if (first != given.npos && second != given.npos) {
    const auto x = number_of_text(given.substr(0, first)),
               y = number_of_text(given.substr(first + 1, second - first - 1)),
               z = number_of_text(given.substr(second + 1));
    if (x && y && z) return push(state, vec(*x, *y, *z));
  }
  lua_pushlstring(state, given.data(), given.size());
}

}  // namespace

void each_given(lua_State* state, int index, const char* call, const char* what,
                const std::function<void(const std::string& name)>& take) {
  if (lua_isnoneornil(state, index)) return;
  require(lua_istable(state, index), call, ": ", what, " must be a table, got ", kind_of_value(state, index));
  const KeysOfTable keys = keys_of(state, index);
  require(keys.count == 0 && !keys.has_others, call, ": ", what, " must have names that are strings");
  for (const std::string& name : keys.names) {
    lua_pushlstring(state, name.data(), name.size());
    lua_rawget(state, index);
    take(name);
    lua_pop(state, 1);
  }
}

const char* const given_what = "argument 2, the parameters,";

std::map<std::string, SceneValue> given_parameters(lua_State* state, int index, const char* call) {
  std::map<std::string, SceneValue> given;
  each_given(state, index, call, given_what, [&](const std::string& name) {
    require(name.find_first_of("=.") == std::string::npos, call, ": a parameter has no '=' or '.' in its name, got '",
            name, "'");
    given[name] = check_value(state, -1, call, text("parameter ", name));
  });
  return given;
}

void push_value(lua_State* state, const SceneValue& value) {
  if (const auto* number = std::get_if<double>(&value))
    lua_pushnumber(state, *number);
  else if (const auto* boolean = std::get_if<bool>(&value))
    lua_pushboolean(state, *boolean);
  else
    lua_pushstring(state, std::get<std::string>(value).c_str());
}

int scene_param(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "param");
  Script& script = self.script;
  SceneParameter p;
  p.name = check_text(state, 2, "param", "argument 1, the name,");
  require(!p.name.empty() && p.name.find_first_of("=.") == std::string::npos,
          "param: argument 1, the name, must not be empty nor have '=' or '.' in it, got '", p.name, "'");
  for (const SceneParameter& other : script.parameters)
    require(other.name != p.name, "param: '", p.name, "' is declared twice");
  p.initial = p.value = check_value(state, 3, "param", "argument 2, the default,");
  p.integer = lua_isinteger(state, 3);
  const Options o(state, 4, "param", {"min", "max", "step", "help", "choices", "on_change"});
  p.min = o.number("min", "");
  p.max = o.number("max", "");
  p.step = o.number("step", "");
  require(!(p.min || p.max || p.step) || std::holds_alternative<double>(p.initial),
          "param: min, max and step are for numbers, and the default of '", p.name, "' is ", type_name(p.initial));
  require(!(p.min && p.max) || *p.min <= *p.max, "param: min of '", p.name, "' must not be above max, got ",
          p.min.value_or(0), " and ", p.max.value_or(0));
  require(!p.step || *p.step > 0, "param: step must be > 0, got ", p.step.value_or(0));
  p.help = o.string("help").value_or("");
  read_choices(state, o, p);
  check_allowed(p, p.initial);
  if (const auto function = o.function("on_change")) {
    script.on_change.insert_or_assign(p.name, *function);
    p.live = true;
  }
  take_command_line(script, p);
  script.parameters.push_back(p);
  push_parameter(state, p);
  return 1;
}

void apply_settings(Script& script) {
  for (const auto& setting : script.options.set) {
    const std::string &name = setting.first, &given = setting.second;
    if (!name.starts_with("scene.")) continue;
    const std::string field_name = name.substr(6);
    const std::string what = text(script.options.set_by, name, "=", given, ": ");
    const auto& fields = scene_type().fields;
    const auto field = std::find_if(fields.begin(), fields.end(), [&](const Field& f) { return f.name == field_name; });
    std::vector<std::string> known;
    for (const Field& f : fields)
      if (writable(f)) known.push_back(f.name);
    if (field == fields.end() || !writable(*field))
      throw UsageError(text(what, "the scene has no setting '", field_name, "'.", suggestion(field_name, known),
                            " Known are ", joined(known)));
    try {
      script.runtime.run([&](lua_State* state) {
        lua_getglobal(state, "scene");
        push_setting(state, *field, given);
        lua_setfield(state, -2, field->name);
      });
    } catch (const Error& error) { throw UsageError(text(what, error.what())); }
    script.fixed.insert(field_name);
  }
}

void check_parameters_known(const Script& script) {
  std::vector<std::string> names;
  for (const SceneParameter& p : script.parameters) names.push_back(p.name);
  for (const auto& [name, given] : script.options.set) {
    if (name.starts_with("scene.") || std::find(names.begin(), names.end(), name) != names.end()) continue;
    throw UsageError(text(script.options.set_by, name, "=", given, ": the scene has no parameter '", name, "'.",
                          suggestion(name, names), names.empty() ? " It has none" : text(" It has ", joined(names))));
  }
}

bool change_parameter(Script& script, const std::string& name, const SceneValue& value) {
  for (SceneParameter& p : script.parameters) {
    if (p.name != name) continue;
    check_allowed(p, value);
    if (!p.live) return false;
    const SceneValue before = p.value;
    p.value = value;
    const SceneParameter copy = p;
    try {
      script.on_change.at(name).call([&](lua_State* state) {
        push_parameter(state, copy);
        return 1;
      });
    } catch (...) {
      p.value = before;
      throw;
    }
    return true;
  }
  throw UsageError(text("the scene has no parameter '", name, "'"));
}

}  // namespace pantin::lua
