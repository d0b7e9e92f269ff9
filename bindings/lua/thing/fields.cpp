#include "lua/thing/fields.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

#include "edit/edit.hpp"
#include "lua/law/law_run.hpp"
#include "lua/law/recheck.hpp"
#include "lua/thing/property_values.hpp"
#include "lua/thing/script.hpp"
#include "lua/value/arguments.hpp"
#include "lua/value/copies.hpp"
#include "lua/value/tostring.hpp"
#include "lua/vm/guard.hpp"
#include "lua/vm/runtime.hpp"

namespace pantin::lua {
namespace {

const Type& type_at_upvalue(lua_State* state) {
  return *static_cast<const Type*>(lua_touserdata(state, lua_upvalueindex(2)));
}

std::vector<std::string> names_of(const Type& type, bool methods) {
  std::vector<std::string> names;
  for (const Field& f : type.fields) names.push_back(f.name);
  if (methods)
    for (const Method& m : type.methods) names.push_back(m.name);
  return names;
}

[[noreturn]] void unknown(const Self& self, const Type& type, const char* what) {
  const std::string name(push_text(self.state, 2));
  std::vector<std::string> methods, own, all = names_of(type, true);
  for (const Method& m : type.methods) methods.push_back(m.name);
  if (type.more_names) {
    require_alive(self.ref);
    own = type.more_names(self);
  }
  all.insert(all.end(), own.begin(), own.end());
  const std::vector<std::string> fields = names_of(type, false);
  throw Error(text(type.word, ": ", what, " '", name, "'.", suggestion(name, all), own.empty() ? "" : " Its own: ",
                   joined(own), own.empty() ? "" : ".", fields.empty() ? "" : " Fields: ", joined(fields),
                   fields.empty() || methods.empty() ? "" : ".", methods.empty() ? "" : " Methods: ", joined(methods)));
}

Self self_at(lua_State* state, int index) {
  const Ref& ref = *to_ref(state, index);
  return {state, ref, *ref.script, ref.script->world};
}

/// Pushes what a property is now. Of a table that a script might write into it is a copy.
void push_property(const Self& self, const char* word, const fields::Property& property) {
  push_value(self.state, self.script, property.read(self.world, self.ref.thing));
  if ((property.write || property.fixed) && lua_istable(self.state, -1))
    lock_copy(self.state, word, property.name, property.write != nullptr);
}

int index(lua_State* state) {
  lua_pushvalue(state, 2);
  lua_rawget(state, lua_upvalueindex(1));
  const int found = lua_type(state, -1);
  const Type& type = type_at_upvalue(state);
  if (found == LUA_TFUNCTION) {
    if (LawRun* law = Runtime::of(state).law)
      law->mistake(state,
                   text("a law reads numbers and returns; it cannot call ", type.word, ":", lua_tostring(state, 2)));
    return 1;
  }
  const Self self = self_at(state, 1);
  if (found == LUA_TLIGHTUSERDATA) {
    const Field& field = *static_cast<const Field*>(lua_touserdata(state, -1));
    if (!field.of_dead) require_alive(self.ref);
    if (LawRun* law = Runtime::of(state).law)
      if (law->on_thing(state, field.name, self.ref.kind == Kind::scene)) return 1;
    if (field.read)
      field.read(self);
    else
      push_property(self, type.word, *field.property);
    return 1;
  }
  if (type.more && lua_type(state, 2) == LUA_TSTRING) {
    require_alive(self.ref);
    if (type.more(self, lua_tostring(state, 2))) return 1;
  }
  unknown(self, type, "unknown field");
}

int new_index(lua_State* state) {
  const Type& type = type_at_upvalue(state);
  if (LawRun* law = Runtime::of(state).law)
    law->mistake(state, text("a law reads numbers and returns; it cannot write to a ", type.word));
  const Self self = self_at(state, 1);
  lua_pushvalue(state, 2);
  lua_rawget(state, lua_upvalueindex(1));
  if (lua_islightuserdata(state, -1)) {
    const Field& field = *static_cast<const Field*>(lua_touserdata(state, -1));
    require(writable(field), type.word, ": ", field.name, " can be read, not written");
    require_alive(self.ref);
    unlock(state, 3);
    if (self.ref.kind == Kind::scene && self.script.fixed.contains(field.name)) return 0;
    if (field.write)
      field.write(self, 3);
    else
      field.property->write(self.world, self.ref.thing, check_value(self, *field.property, 3));
    return 0;
  }
  require(!lua_isfunction(state, -1), type.word, ": ", lua_tostring(state, 2), " is a method and cannot be written");
  if (type.write_more && lua_type(state, 2) == LUA_TSTRING) {
    require_alive(self.ref);
    if (type.write_more(self, lua_tostring(state, 2), 3)) return 0;
  }
  if (type.more_names && lua_type(state, 2) == LUA_TSTRING) {
    require_alive(self.ref);
    const std::vector<std::string> own = type.more_names(self);
    require(std::find(own.begin(), own.end(), lua_tostring(state, 2)) == own.end(), type.word, ": ",
            lua_tostring(state, 2), " can be read, not written");
  }
  unknown(self, type, "cannot write unknown field");
}

int thing_text(lua_State* state) {
  const std::string name = describe(*to_ref(state, 1));
  lua_pushlstring(state, name.data(), name.size());
  return 1;
}

}  // namespace

void lock_copy(lua_State* state, const char* word, const char* name, bool can_be_written) {
  lock(state, can_be_written ? text(word, ": ", name, " is a copy: give the whole, x.", name, " = ")
                             : text(word, ": ", name, " can be read, not written"));
}

bool writable(const Field& field) { return field.write || (field.property && field.property->write); }

std::vector<Field> fields_of(const fields::Type& type) {
  std::vector<Field> all;
  for (const fields::Property& p : type.properties)
    all.push_back({p.name, p.type, p.unit, p.doc, nullptr, nullptr, p.of_dead, &p});
  return all;
}

Type type_with(const fields::Type& type) { return {type.name, type.word, type.doc, fields_of(type), {}}; }

Field& field_named(Type& type, std::string_view name) {
  const auto found =
      std::find_if(type.fields.begin(), type.fields.end(), [&](const Field& f) { return f.name == name; });
  assume(found != type.fields.end());
  return *found;
}

void read_energy(const Self& self) {
  if (!self.world.locked && !Runtime::of(self.state).law) renew_laws(self.world, self.script.laws);
  push_value(self.state, self.script, fields::read(self.world, self.ref.thing, "energy"));
}

const Type& type_of(Kind kind) {
  if (is_constraint(kind)) return constraint_type(kind);
  switch (kind) {
    case Kind::point: return point_type();
    case Kind::particle: return particle_type();
    case Kind::body: return body_type();
    case Kind::group: return group_type();
    case Kind::family: return family_type();
    case Kind::connection: return connection_type();
    case Kind::interaction: return interaction_type();
    case Kind::field: return field_type();
    case Kind::emitter: return emitter_type();
    case Kind::collider: return collider_type();
    case Kind::event: return event_type();
    case Kind::hand: return hand_type();
    case Kind::subscription: return subscription_type();
    case Kind::structure: return structure_type();
    case Kind::shape: return shape_type();
    case Kind::draw: return draw_type();
    case Kind::held_keys: return held_keys_type();
    case Kind::gamepad: return gamepad_type();
    case Kind::mouse: return mouse_type();
    case Kind::camera: return camera_type();
    case Kind::saved: return saved_type();
    case Kind::snapshot: return snapshot_type();
    default: return scene_type();
  }
}

std::vector<const Type*> all_types() {
  std::vector<const Type*> types;
  for (std::uint32_t k = 0; k < kind_count; k++) types.push_back(&type_of(static_cast<Kind>(k)));
  types.push_back(&type_of_opened_scene());
  return types;
}

std::vector<const Type*> base_types() {
  return {&any_thing_type(), &any_constraint_type(), &any_force_element_type(), &any_set_type(), &any_scene_type()};
}

namespace {

/// How many arguments a method takes at most, as its annotation has them; none: any number.
std::optional<int> most_arguments(std::string_view parameters) {
  if (parameters.empty()) return 0;
  int count = 1, depth = 0;
  for (const char c : parameters) {
    if (std::string_view("([<{").find(c) != std::string_view::npos) depth++;
    if (std::string_view(")]>}").find(c) != std::string_view::npos) depth--;
    if (c == ',' && depth == 0) count++;
  }
  return parameters.find("...") == std::string_view::npos ? std::optional(count) : std::nullopt;
}

/// Calls the method that is upvalue `at`, whose arguments begin at `first`, with no more of them than the next upvalue.
int call_counted(lua_State* state, int at, int first) {
  const auto& method = *static_cast<const Method*>(lua_touserdata(state, lua_upvalueindex(at)));
  check_count(state, static_cast<int>(lua_tointeger(state, lua_upvalueindex(at + 1))), method.name, first);
  for (int i = lua_gettop(state); i >= first; i--) unlock(state, i);
  return method.function(state);
}
int call_method(lua_State* state) { return call_counted(state, 1, 2); }
int call_maker(lua_State* state) { return call_counted(state, 2, 1); }

/// The upvalues of those.
bool push_counted(lua_State* state, const Method& method) {
  const auto most = most_arguments(method.parameters);
  if (!most) return false;
  lua_pushlightuserdata(state, const_cast<Method*>(&method));
  lua_pushinteger(state, *most);
  return true;
}

void push_method(lua_State* state, const Method& method) {
  if (push_counted(state, method))
    lua_pushcclosure(state, guard<call_method>, 2);
  else
    lua_pushcfunction(state, method.function);
}

}  // namespace

void push_maker(lua_State* state, const Method& maker, Script& script) {
  lua_pushlightuserdata(state, &script);
  if (push_counted(state, maker))
    lua_pushcclosure(state, guard<call_maker>, 3);
  else
    lua_pushcclosure(state, maker.function, 1);
}

void push_metatable(lua_State* state, Kind kind) { push_metatable(state, type_of(kind)); }

void push_metatable(lua_State* state, const Type& type) {
  if (lua_rawgetp(state, LUA_REGISTRYINDEX, &type) != LUA_TNIL) return;
  lua_pop(state, 1);
  lua_newtable(state);
  lua_newtable(state);
  for (const Method& method : type.methods) {
    push_method(state, method);
    lua_setfield(state, -2, method.name);
  }
  // A name that both a field and a method have reads as the field, see box_call.hpp.
  for (const Field& field : type.fields) {
    lua_pushlightuserdata(state, const_cast<Field*>(&field));
    lua_setfield(state, -2, field.name);
  }
  const auto add = [&](const char* name, lua_CFunction function) {
    lua_pushvalue(state, -1);
    lua_pushlightuserdata(state, const_cast<Type*>(&type));
    lua_pushcclosure(state, function, 2);
    lua_setfield(state, -3, name);
  };
  add("__index", guard<index>);
  add("__newindex", guard<new_index>);
  lua_pop(state, 1);
  lua_pushcfunction(state, guard<thing_text>);
  lua_setfield(state, -2, "__tostring");
  for (const char* key : {"__name", "__metatable"}) {
    lua_pushstring(state, type.word);
    lua_setfield(state, -2, key);
  }
  if (type.length) {
    lua_pushcfunction(state, type.length);
    lua_setfield(state, -2, "__len");
  }
  lua_pushvalue(state, -1);
  lua_rawsetp(state, LUA_REGISTRYINDEX, &type);
}

Self check_self_or_dead(lua_State* state, Kind kind, const char* call) {
  const Ref* ref = to_ref(state, 1);
  const char* word = type_of(kind).word;
  require(ref && ref->kind == kind, word, ": call ", call, " with a colon, ", word, ":", call, "(…)");
  return {state, *ref, *ref->script, ref->script->world};
}

Self check_self(lua_State* state, Kind kind, const char* call) {
  const Self self = check_self_or_dead(state, kind, call);
  require_alive(self.ref);
  return self;
}

bool has_member(const Type& type, const std::string& name) {
  for (const std::string& known : names_of(type, true))
    if (known == name) return true;
  return false;
}

}  // namespace pantin::lua
