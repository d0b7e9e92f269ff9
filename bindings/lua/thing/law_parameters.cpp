#include "lua/thing/law_parameters.hpp"

#include <algorithm>

#include "edit/edit.hpp"
#include "laws/law.hpp"
#include "lua/thing/handles.hpp"
#include "lua/thing/property_values.hpp"
#include "lua/thing/script.hpp"
#include "lua/value/arguments.hpp"
#include "lua/value/copies.hpp"
#include "lua/vm/guard.hpp"

namespace pantin::lua {
namespace {

const char parameters_key = 0;  // of the registry

/// Calls `use` with the id of the thing, whichever of the three it is.
template <class Use>
decltype(auto) with_id(const Ref& ref, Use&& use) {
  if (ref.kind == Kind::connection) return use(ref.id<ConnectionId>());
  if (ref.kind == Kind::interaction) return use(ref.id<InteractionId>());
  return use(ref.id<FieldId>());
}

const Connection& row_of(const World& world, ConnectionId id) { return world.connections[id]; }
const Interaction& row_of(const World& world, InteractionId id) { return world.interactions[id]; }
const pantin::Field& row_of(const World& world, FieldId id) { return world.fields[id]; }

/// Index of a parameter; throws Error that names those there are.
std::size_t find_parameter(const Law& law, const std::string& name) {
  std::vector<std::string> names;
  for (const pantin::Parameter& p : law.parameters) names.push_back(p.name);
  const auto found = std::find(names.begin(), names.end(), name);
  require(found != names.end(), "parameters: the law ", law.name, " has no '", name, "'.", suggestion(name, names),
          " It has ", names.empty() ? "none" : joined(names));
  return static_cast<std::size_t>(found - names.begin());
}

/// Of the table at argument 1.
const Ref& check_thing(lua_State* state) {
  const Ref* thing = thing_of_parameters(state, 1);
  require(thing != nullptr, "parameters: this is no table of parameters");
  require_alive(*thing);
  return *thing;
}

int read_parameter(lua_State* state) {
  const Ref& ref = check_thing(state);
  with_id(ref, [&](auto id) {
    const auto& row = row_of(ref.script->world, id);
    lua_pushnumber(state, row.parameters[find_parameter(*row.law, check_text(state, 2, "parameters", "a name"))]);
  });
  return 1;
}

int write_parameter(lua_State* state) {
  const Ref& ref = check_thing(state);
  with_id(ref, [&](auto id) {
    const std::string name = check_text(state, 2, "parameters", "a name");
    const std::size_t index = find_parameter(*row_of(ref.script->world, id).law, name);
    set_parameter(ref.script->world, id, index, check_number(state, 3, "parameters", name, ""));
  });
  return 0;
}

int list_parameters(lua_State* state) {
  const Ref& ref = check_thing(state);
  push_value(state, *ref.script, fields::read(ref.script->world, ref.thing, "parameters"));
  return 1;
}

}  // namespace

void push_law_parameters_type(lua_State* state) {
  if (lua_rawgetp(state, LUA_REGISTRYINDEX, &parameters_key) != LUA_TNIL) return;
  lua_pop(state, 1);
  lua_newtable(state);
  const luaL_Reg functions[] = {{"__index", guard<read_parameter>},
                                {"__newindex", guard<write_parameter>},
                                {contents_field, guard<list_parameters>},
                                {nullptr, nullptr}};
  luaL_setfuncs(state, functions, 0);
  lua_pushliteral(state, "parameters");
  lua_setfield(state, -2, "__metatable");
  lua_pushvalue(state, -1);
  lua_rawsetp(state, LUA_REGISTRYINDEX, &parameters_key);
}

/// The thing is at a key that is no name.
void push_law_parameters(lua_State* state, const Ref& thing) {
  lua_createtable(state, 0, 1);
  lua_pushboolean(state, 0);
  push_ref(state, thing);
  lua_rawset(state, -3);
  push_law_parameters_type(state);
  lua_setmetatable(state, -2);
}

const Ref* thing_of_parameters(lua_State* state, int index) {
  index = lua_absindex(state, index);
  if (!lua_istable(state, index) || !lua_getmetatable(state, index)) return nullptr;
  push_law_parameters_type(state);
  const bool same = lua_rawequal(state, -1, -2);
  lua_pop(state, 2);
  if (!same) return nullptr;
  lua_pushboolean(state, 0);
  lua_rawget(state, index);
  const Ref* thing = to_ref(state, -1);
  lua_pop(state, 1);
  const bool has_law =
      thing && (thing->kind == Kind::connection || thing->kind == Kind::interaction || thing->kind == Kind::field);
  return has_law ? thing : nullptr;
}

}  // namespace pantin::lua
