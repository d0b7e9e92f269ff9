#include "lua/thing/family_options.hpp"

#include <algorithm>

#include "lua/law/curve_options.hpp"
#include "lua/thing/fields.hpp"
#include "lua/thing/look_options.hpp"
#include "lua/thing/picture_options.hpp"
#include "lua/thing/script.hpp"
#include "lua/thing/targets.hpp"

namespace pantin::lua {
namespace {

/// Attributes are a list of names, which start at 0, or a table of names and values.
void read_attributes(lua_State* state, int table, const std::string& what, Looks& looks) {
  require(lua_istable(state, table), what, ": attributes must be a table { charge = 1 } or { \"charge\" }, got ",
          kind_of_value(state, table));
  const KeysOfTable keys = keys_of(state, table);
  require(!keys.has_others, what, ": attributes must be a list without gaps, or have names");
  for (lua_Integer i = 1; i <= keys.count; i++) {
    lua_rawgeti(state, table, i);
    looks.attributes.push_back({check_text(state, -1, what, text("name ", i, " of the attributes")), 0.0});
    lua_pop(state, 1);
  }
  for (const std::string& name : keys.names) {
    lua_pushlstring(state, name.data(), name.size());
    lua_rawget(state, table);
    const int value = lua_gettop(state);
    const bool follows = lua_isfunction(state, value);
    if (follows) looks.curves = with(looks.curves.get(), curve_of(state, value, what, name));
    looks.attributes.push_back(
        {name, follows ? 0.0 : check_number(state, value, what, text("attribute '", name, "'"), "")});
    lua_pop(state, 1);
  }
  for (const AttributeDef& def : looks.attributes)
    require(!has_member(particle_type(), def.name), what, ": an attribute cannot be called '", def.name,
            "', which a particle has already");
}

}  // namespace

FamilyOption family_option(lua_State* state, int index, const std::string& what, std::vector<std::string_view>& known) {
  FamilyOption option;
  known.push_back("family");
  if (!lua_istable(state, index)) return option;
  lua_getfield(state, index, "family");
  if (!lua_isnil(state, -1)) {
    const Ref& ref = check_kind(state, lua_gettop(state), Kind::family, what, "family");
    option.id = ref.id<FamilyId>();
    for (const Family::Attribute& a : ref.script->world.families[option.id].attributes)
      option.attributes.push_back(a.name);
    known.insert(known.end(), option.attributes.begin(), option.attributes.end());
  }
  lua_pop(state, 1);
  return option;
}

std::vector<AttributeDef> attribute_options(const Options& options, const std::vector<std::string>& attributes) {
  std::vector<AttributeDef> given;
  for (const std::string& name : attributes)
    if (const auto value = options.number(name.c_str(), "")) given.push_back({name, *value});
  return given;
}

namespace {

/// How its particles touch, where `solid` says that they do.
void read_solid(const Options& o, const std::string& what, FamilyDef& def) {
  if (o.boolean("solid").value_or(false)) def.solid.emplace();
  for (const char* name : {"friction", "restitution", "layer"})
    require(!o.has(name) || def.solid, what, ": ", name, " is of what is solid; give it solid = true, too");
  if (!def.solid) return;
  def.solid->friction = o.number("friction", "").value_or(def.solid->friction);
  def.solid->restitution = o.number("restitution", "").value_or(def.solid->restitution);
  def.layer = o.string("layer").value_or("");
  require(!o.has("layer") || !def.layer.empty(), what, ": layer must not be empty");
}

}  // namespace

int scene_family(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "family");
  FamilyDef def;
  def.name = check_text(state, 2, "family", "argument 1, the name,");
  const std::string what = text("family '", def.name, "'");
  const Options o(
      state, 3, what,
      {"attributes", "color", "radius", "mass", "look", "sprite", "solid", "friction", "restitution", "layer"});
  Looks looks = look_options(o, {});
  if (o.has("attributes")) {
    read_attributes(state, o.push("attributes"), what, looks);
    lua_pop(state, 1);
  }
  def.attributes = looks.attributes;
  def.color = looks.color;
  def.radius = looks.radius;
  def.look = looks.look;
  def.sprite = sprite_option(self.script, o);
  def.curves = looks.curves;
  def.mass = o.number("mass", "kg");
  read_solid(o, what, def);
  push_thing(state, self.script, add_family(self.world, def));
  return 1;
}

}  // namespace pantin::lua
