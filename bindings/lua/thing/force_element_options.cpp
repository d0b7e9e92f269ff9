#include "lua/thing/force_element_options.hpp"

#include <algorithm>

#include "choreography/bonding.hpp"
#include "edit/edit.hpp"
#include "lua/law/force.hpp"
#include "lua/law/force_library.hpp"
#include "lua/thing/fields.hpp"
#include "lua/thing/script.hpp"
#include "lua/thing/script_functions.hpp"
#include "lua/thing/targets.hpp"
#include "lua/value/arguments.hpp"
#include "lua/vm/guard.hpp"

namespace pantin::lua {
namespace {

KnownNames names_of(const World& world, const End& end) {
  if (!end.particle) {
    const auto number = [&](int i) { return to_text(end.position[i]); };
    return {text("the position vec(", number(0), ", ", number(1), ", ", number(2), ") m of the world"), {}, true};
  }
  const FamilyId family = world.particles[awake(world, end.particle)].family;
  return family ? names_of_family(world, family) : KnownNames{"a particle of no family", {}, false};
}

/// What a law may read of any particle of the scene: each must have it when the law acts.
KnownNames names_of_all(const World& world) {
  KnownNames known{"the scene", {}};
  for (FamilyId family : world.families.ids())
    for (const Family::Attribute& a : world.families[family].attributes) known.attributes.push_back(a.name);
  std::sort(known.attributes.begin(), known.attributes.end());
  known.attributes.erase(std::unique(known.attributes.begin(), known.attributes.end()), known.attributes.end());
  return known;
}

/// A particle, a point for its particle, or a place of the world.
End end_at(lua_State* state, int index, const std::string& name) {
  if (to_vec(state, index)) return {{}, check_vec(state, index, "connect", name, "m")};
  const Ref* ref = to_ref(state, index);
  require(!ref || ref->kind != Kind::body, "connect: ", name,
          " must be a particle, a point or a vec, got a body; name one of its points");
  require(ref && (ref->kind == Kind::point || ref->kind == Kind::particle), "connect: ", name,
          " must be a particle, a point or a vec, got ", kind_of_value(state, index));
  require_alive(*ref);
  if (ref->kind == Kind::particle) return {ref->id<ParticleId>()};
  return {ref->script->world.points[ref->id<PointId>()].own};
}

/// The ends of a connection, and where the law stands among the arguments.
std::vector<End> ends_of(lua_State* state, int& law) {
  std::vector<End> ends;
  if (lua_istable(state, 2)) {
    const auto count = lua_rawlen(state, 2);
    for (lua_Unsigned i = 1; i <= count; i++) {
      lua_rawgeti(state, 2, static_cast<lua_Integer>(i));
      ends.push_back(end_at(state, lua_gettop(state), text("element ", i, " of argument 1")));
      lua_pop(state, 1);
    }
    law = 3;
  } else {
    ends = {end_at(state, 2, argument(1)), end_at(state, 3, argument(2))};
    law = 4;
  }
  return ends;
}

/// Between all pairs there is no present distance to stand for what was not given.
void require_values(const char* call, const Law& law) {
  for (const pantin::Parameter& p : law.parameters)
    require(!p.present, call, ": ", law.name, ": ", p.name, " must be given", p.unit.empty() ? "" : ", in ", p.unit);
}

/// The families of a bonding.
std::vector<FamilyId> families_of(const Options& o) {
  lua_State* state = o.state();
  std::vector<FamilyId> list;
  const int families = o.push("families");
  if (!lua_istable(state, families)) {
    list.push_back(check_kind(state, families, Kind::family, "bonding", "families").id<FamilyId>());
  } else {
    const auto count = lua_rawlen(state, families);
    for (lua_Unsigned i = 1; i <= count; i++) {
      lua_rawgeti(state, families, static_cast<lua_Integer>(i));
      list.push_back(
          check_kind(state, lua_gettop(state), Kind::family, "bonding", text("families[", i, "]")).id<FamilyId>());
      lua_pop(state, 1);
    }
  }
  lua_pop(state, 1);
  require(list.size() == 1 || list.size() == 2, "bonding: families must be one or two, got ", list.size());
  require(list.size() == 1 || !(list[0] == list[1]), "bonding: the two families are one; give it once");
  return list;
}

/// The law of a bonding.
void set_law(const Self& self, const Options& o, BondingDef& def) {
  const KnownNames known[] = {names_of_family(self.world, def.families.front()),
                              names_of_family(self.world, def.families.back())};
  const ResolvedLaw resolved = resolve_law(self.state, o.push("law"), self.world, known, def.families.size() == 1);
  lua_pop(self.state, 1);
  def.law = resolved.laws.front();
  def.parameters = resolved.values;
  def.solve = o.has("implicit") ? read_implicit(o) : resolved.solve;
  def.on_connection = WatchedBond{&self.script.laws, resolved};
}

}  // namespace

KnownNames names_of_family(const World& world, FamilyId family) {
  KnownNames known{describe(world, family), {}};
  for (const Family::Attribute& a : world.families[family].attributes) known.attributes.push_back(a.name);
  return known;
}

ConnectionId connect(const Self& self, std::vector<End> ends, int at) {
  lua_State* state = self.state;
  ConnectionDef def;
  def.ends = std::move(ends);
  std::vector<KnownNames> known;
  for (const End& end : def.ends) known.push_back(names_of(self.world, end));
  if (const LawSpec* spec = to_law(state, at); spec && spec->kind != LawKind::point)
    require(static_cast<std::size_t>(spec->count) == def.ends.size(), "connect: ", spec->word, " ties ", spec->count,
            " particles, got ", def.ends.size());
  const ResolvedLaw resolved = resolve_law(state, at, self.world, known, false);
  const std::shared_ptr<const Law>& law = resolved.laws.front();
  std::vector<std::string_view> names;
  for (const pantin::Parameter& p : law->parameters) names.push_back(p.name);
  names.insert(names.end(), {"breaks_at", "implicit", "name"});
  const Options o(state, at + 1, "connect", names);
  def.parameters = resolved.values;
  for (std::size_t k = 0; k < law->parameters.size(); k++) {
    const auto given = o.number(law->parameters[k].name.c_str(), law->parameters[k].unit.c_str());
    if (given)
      def.parameters[k] = *given;
    else if (law->parameters[k].present)
      def.parameters[k] = present_value(self.world, def.ends);
  }
  if (o.has("breaks_at")) {
    const Options limits(state, o.push("breaks_at"), "connect: breaks_at", {"force", "length"});
    def.max_force = limits.number_or_infinity("force", "N").value_or(infinity);
    def.max_length = limits.number_or_infinity("length", "m").value_or(infinity);
    lua_pop(state, 1);
  }
  def.solve = o.has("implicit") ? read_implicit(o) : resolved.solve;
  def.name = o.string("name").value_or("");
  const ConnectionId id = add_connection(self.world, law, def);
  watch_law(self.script.laws, id, resolved);
  return id;
}

int scene_connect(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "connect");
  int at = 0;
  std::vector<End> ends = ends_of(state, at);
  require(lua_isnoneornil(state, at + 2), "connect: its table of options comes last, got ",
          kind_of_value(state, at + 2), " after it");
  push_thing(state, self.script, connect(self, std::move(ends), at));
  return 1;
}

int scene_bonding(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "bonding");
  require(lua_istable(state, 2), "bonding: argument 1 must be a table { families, near, below, above, law }, got ",
          kind_of_value(state, 2));
  const Options o(state, 2, "bonding",
                  {"families", "near", "below", "above", "law", "implicit", "hinge", "time_constant"});
  BondingDef def;
  def.families = families_of(o);
  const auto needed = [&](const char* name, const char* unit) {
    const auto value = o.number(name, unit);
    require(value.has_value(), "bonding: ", name, " [", unit, "] is missing");
    return *value;
  };
  def.near = needed("near", "m");
  def.below = needed("below", "K");
  def.above = needed("above", "K");
  const bool hinge = o.boolean("hinge").value_or(false);
  require(hinge != o.has("law"),
          "bonding: what is near and cold is tied by law = … or joined by hinge = true; give one");
  require(!hinge || !o.has("implicit"), "bonding: implicit is for the connections of a law");
  require(hinge || !o.has("time_constant"), "bonding: time_constant is for hinge = true");
  def.time_constant = o.number("time_constant", "s").value_or(def.time_constant);
  if (!hinge) set_law(self, o, def);
  def.label = where(state);
  push_event(state, self.script, add_bonding(self.world, std::move(def)));
  return 1;
}

int scene_interact(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "interact");
  const auto a = check_kind(state, 2, Kind::family, "interact", argument(1)).id<FamilyId>();
  const auto b = check_kind(state, 3, Kind::family, "interact", argument(2)).id<FamilyId>();
  const KnownNames known[] = {names_of_family(self.world, a), names_of_family(self.world, b)};
  const ResolvedLaw resolved = resolve_law(state, 4, self.world, known, a == b);
  require_values("interact", *resolved.laws.front());
  require(resolved.solve == Solve::explicitly, "interact: implicit is for connections");
  const InteractionId id = add_interaction(self.world, resolved.laws.front(), a, b, resolved.values);
  watch_law(self.script.laws, id, resolved);
  push_thing(state, self.script, id);
  return 1;
}

int scene_field(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "field");
  const Ref* ref = to_ref(state, 2);
  require(ref && (ref->kind == Kind::family || ref->kind == Kind::group || ref->kind == Kind::scene),
          "field: argument 1 must be a family, a group or the scene, got ", kind_of_value(state, 2));
  require_alive(*ref);
  const KnownNames known[] = {ref->kind == Kind::family ? names_of_family(self.world, ref->id<FamilyId>())
                                                        : names_of_all(self.world)};
  const ResolvedLaw resolved = resolve_law(state, 3, self.world, known, false);
  const FieldId id = add_field(self.world, resolved.laws.front(), ref->thing, resolved.values);
  watch_law(self.script.laws, id, resolved);
  push_thing(state, self.script, id);
  return 1;
}

}  // namespace pantin::lua
