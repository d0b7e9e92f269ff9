// Connection, interaction and field: what makes laws act.
#include <algorithm>

#include "edit/edit.hpp"
#include "forces/forces.hpp"
#include "laws/law.hpp"
#include "lua/thing/fields.hpp"
#include "lua/thing/script.hpp"
#include "lua/value/arguments.hpp"
#include "lua/vm/guard.hpp"

namespace pantin::lua {
namespace {

ConnectionId connection_of(const Self& self) { return self.ref.id<ConnectionId>(); }

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
  lua_setmetatable(state, -2);
}

const Field parameters = {"parameters",    "table<string, number>",
                          "each its own",  "of its law: read and written by name",
                          read_parameters, nullptr};
const Field energy = {"energy",
                      "number?",
                      "J",
                      "of its law now; nil where the law has none",
                      [](const Self& s) {
                        const auto joules = with_id(s.ref, [&](auto id) { return law_energy(s.world, id); });
                        if (joules)
                          lua_pushnumber(s.state, *joules);
                        else
                          lua_pushnil(s.state);
                      },
                      nullptr};
const Field enabled = {"enabled",
                       "boolean",
                       "",
                       "whether it acts (default `true`)",
                       [](const Self& s) {
                         lua_pushboolean(s.state, with_id(s.ref, [&](auto id) { return row_of(s.world, id).enabled; }));
                       },
                       [](const Self& s, int i) {
                         const bool on = check_boolean(s.state, i, type_of(s.ref.kind).word, "enabled");
                         with_id(s.ref, [&](auto id) { set_enabled(s.world, id, on); });
                       }};

void read_breaks_at(const Self& self) {
  const Connection& row = self.world.connections[connection_of(self)];
  lua_newtable(self.state);
  const auto set = [&](const char* name, double value) {
    if (!std::isfinite(value)) return;
    lua_pushnumber(self.state, value);
    lua_setfield(self.state, -2, name);
  };
  set("force", row.max_force);
  set("length", row.max_length);
}

void write_breaks_at(const Self& self, int index) {
  const Options o(self.state, index, "connection: breaks_at", {"force", "length"});
  set_breaks_at(self.world, connection_of(self), o.number_or_infinity("force", "N").value_or(infinity),
                o.number_or_infinity("length", "m").value_or(infinity));
}

void read_particles(const Self& self) {
  const Connection& row = self.world.connections[connection_of(self)];
  lua_newtable(self.state);
  for (std::uint32_t i = 0; i < row.count; i++) {
    if (row.particles[i])
      push_thing(self.state, self.script, row.particles[i]);
    else
      push(self.state, row.positions[i]);
    lua_rawseti(self.state, -2, static_cast<lua_Integer>(i + 1));
  }
}

Type make_connection() {
  Type type{"Connection", "connection", "Ties two, three or four particles by a law.", {}, {}};
  type.fields = {
      {"particles", "(Particle|vec)[]", "m", "what it ties: particles, or positions", read_particles, nullptr},
      {"force", "number", "N", "tension in the last step, positive where it pulls; 0 of a law of three or four",
       [](const Self& s) { lua_pushnumber(s.state, tension(s.world, connection_of(s))); }, nullptr},
      {"breaks_at", "Breaking", "", "tension or length at which it breaks (default `{}`)", read_breaks_at,
       write_breaks_at},
  };
  add_base(type, any_force_element_type());
  add_common_remove(type);
  return type;
}

Type make_interaction() {
  Type type{"Interaction", "interaction", "A law between all pairs of two families, or within one.", {}, {}};
  add_base(type, any_force_element_type());
  add_common_remove(type);
  return type;
}

Type make_field() {
  Type type{"Field", "field", "A law on each particle of a family, of a group or of the scene.", {}, {}};
  add_base(type, any_force_element_type());
  add_common_remove(type);
  return type;
}

}  // namespace

const Type& any_force_element_type() {
  static const Type type = [] {
    Type made{"AnyForceElement",
              "force element",
              "What every connection, interaction and field has.",
              {parameters, energy, enabled},
              {}};
    made.base = &any_thing_type();
    return made;
  }();
  return type;
}
const Type& connection_type() {
  static const Type type = make_connection();
  return type;
}
const Type& interaction_type() {
  static const Type type = make_interaction();
  return type;
}
const Type& field_type() {
  static const Type type = make_field();
  return type;
}

}  // namespace pantin::lua
