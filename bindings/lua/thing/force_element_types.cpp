// Connection, interaction and field: what makes laws act.
#include <algorithm>

#include "edit/edit.hpp"
#include "laws/law.hpp"
#include "lua/thing/fields.hpp"
#include "lua/thing/script.hpp"
#include "lua/value/arguments.hpp"
#include "lua/value/copies.hpp"
#include "lua/vm/guard.hpp"

namespace pantin::lua {
namespace {

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

/// Upvalue: the thing.
int read_parameter(lua_State* state) {
  const Ref& ref = *to_ref(state, lua_upvalueindex(1));
  require_alive(ref);
  with_id(ref, [&](auto id) {
    const auto& row = row_of(ref.script->world, id);
    lua_pushnumber(state, row.parameters[find_parameter(*row.law, check_text(state, 2, "parameters", "a name"))]);
  });
  return 1;
}

int write_parameter(lua_State* state) {
  const Ref& ref = *to_ref(state, lua_upvalueindex(1));
  require_alive(ref);
  with_id(ref, [&](auto id) {
    const std::string name = check_text(state, 2, "parameters", "a name");
    const std::size_t index = find_parameter(*row_of(ref.script->world, id).law, name);
    set_parameter(ref.script->world, id, index, check_number(state, 3, "parameters", name, ""));
  });
  return 0;
}

int list_parameters(lua_State* state) {
  const Ref& ref = *to_ref(state, lua_upvalueindex(1));
  require_alive(ref);
  push_value(state, *ref.script, fields::read(ref.script->world, ref.thing, "parameters"));
  return 1;
}

/// A table that reads and writes the parameters of the law in use.
void read_parameters(const Self& self) {
  lua_State* state = self.state;
  lua_newtable(state);
  lua_newtable(state);
  push_ref(state, self.ref);
  lua_pushcclosure(state, guard<read_parameter>, 1);
  lua_setfield(state, -2, "__index");
  push_ref(state, self.ref);
  lua_pushcclosure(state, guard<write_parameter>, 1);
  lua_setfield(state, -2, "__newindex");
  push_ref(state, self.ref);
  lua_pushcclosure(state, guard<list_parameters>, 1);
  lua_setfield(state, -2, contents_field);
  lua_setmetatable(state, -2);
}

Type make(const fields::Type& properties) {
  Type type = type_with(properties);
  add_base(type, any_force_element_type());
  add_common_remove(type);
  return type;
}

}  // namespace

const Type& any_force_element_type() {
  static const Type type = [] {
    Type made = type_with(fields::any_force_element_type());
    field_named(made, "parameters").read = read_parameters;
    field_named(made, "energy").read = read_energy;
    made.base = &any_thing_type();
    return made;
  }();
  return type;
}
const Type& connection_type() {
  static const Type type = make(fields::connection_type());
  return type;
}
const Type& interaction_type() {
  static const Type type = make(fields::interaction_type());
  return type;
}
const Type& field_type() {
  static const Type type = make(fields::field_type());
  return type;
}

}  // namespace pantin::lua
