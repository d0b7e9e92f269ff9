#include "lua/scene/inspect.hpp"

#include "lua/scene/script_scene.hpp"
#include "lua/thing/fields.hpp"
#include "lua/thing/script.hpp"
#include "lua/vm/guard.hpp"

namespace pantin::lua {
namespace {

/// Reads the value at the top; false for what is not shown.
bool take(lua_State* state, FieldReading& reading) {
  switch (lua_type(state, -1)) {
    case LUA_TNUMBER: reading.value = lua_tonumber(state, -1); return true;
    case LUA_TBOOLEAN: reading.value = lua_toboolean(state, -1) != 0; return true;
    case LUA_TSTRING: reading.value = std::string(lua_tostring(state, -1)); return true;
    case LUA_TNIL: return true;
    default: break;
  }
  if (const auto vector = to_vec(state, -1)) return reading.value = *vector, true;
  if (const Ref* ref = to_ref(state, -1)) return reading.thing = any_of(*ref), true;
  return false;
}

void push_reading(lua_State* state, const FieldReading& reading) {
  if (const auto* number = std::get_if<double>(&reading.value))
    lua_pushnumber(state, *number);
  else if (const auto* boolean = std::get_if<bool>(&reading.value))
    lua_pushboolean(state, *boolean);
  else if (const auto* string = std::get_if<std::string>(&reading.value))
    lua_pushlstring(state, string->data(), string->size());
  else if (const auto* vector = std::get_if<Vec3>(&reading.value))
    push(state, *vector);
  else
    lua_pushnil(state);
}

}  // namespace

std::vector<FieldReading> read_fields(Scene& scene, const AnyId& thing) {
  std::vector<FieldReading> readings;
  Script& script = script_of(scene);
  if (!alive(script.world, thing)) return readings;
  script.runtime.run([&](lua_State* state) {
    push_thing(state, script, thing);
    const Ref* ref = to_ref(state, -1);
    if (!ref) return;
    const Self self{state, *ref, script, script.world};
    for (const Field& field : type_of(ref->kind).fields) {
      const std::string_view type = field.type, name = field.name;
      if (field.of_dead || name == "data" || type.ends_with("[]")) continue;  // `data` is made by reading it
      FieldReading reading{field.name, field.unit, field.doc, field.write != nullptr, {}, {}};
      const int top = lua_gettop(state);
      try {
        field.read(self);
        if (take(state, reading)) readings.push_back(std::move(reading));
      } catch (const Error&) {}  // it has none at present
      lua_settop(state, top);
    }
  });
  return readings;
}

void write_field(Scene& scene, const AnyId& thing, const std::string& name, const FieldReading& value) {
  Script& script = script_of(scene);
  script.runtime.run([&](lua_State* state) {
    push_thing(state, script, thing);
    push_reading(state, value);
    lua_setfield(state, -2, name.c_str());
  });
}

}  // namespace pantin::lua
