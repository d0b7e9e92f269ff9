#include "lua/thing/emitter_options.hpp"

#include "fields/emitter.hpp"
#include "lua/thing/family_options.hpp"
#include "lua/thing/fields.hpp"
#include "lua/thing/look_options.hpp"
#include "lua/thing/script.hpp"
#include "lua/thing/script_functions.hpp"
#include "lua/thing/targets.hpp"

namespace pantin::lua {

EmitterPosition check_emitter_position(lua_State* state, int index, const std::string& what) {
  EmitterPosition place;
  if (to_ref(state, index)) {
    place.point = check_point(state, index, what, "at");
  } else if (lua_istable(state, index)) {
    require(lua_rawlen(state, index) == 2, what, ": at as a box must be { vec, vec }, two opposite corners [m]");
    lua_rawgeti(state, index, 1);
    lua_rawgeti(state, index, 2);
    const int top = lua_gettop(state);
    place.at = check_vec(state, top - 1, what, "the first corner of at", "m");
    place.to = check_vec(state, top, what, "the second corner of at", "m");
    lua_pop(state, 2);
  } else {
    require(to_vec(state, index).has_value(), what,
            ": at must be a vec [m], a box { vec, vec }, a point or a particle, got ", kind_of_value(state, index));
    place.at = check_vec(state, index, what, "at", "m");
  }
  return place;
}

std::pair<double, double> check_lifetimes(lua_State* state, int index, const std::string& what) {
  if (!lua_istable(state, index)) {
    const double lifetime = check_number_or_infinity(state, index, what, "lifetime", "s");
    return {lifetime, lifetime};
  }
  const Options o(state, index, what + ": lifetime", {"min", "max"});
  const auto min = o.number("min", "s"), max = o.number("max", "s");
  require(min && max, what, ": lifetime must be a number [s] or { min = a, max = b }");
  return {*min, *max};
}

std::function<double(double)> rate_function(const Callback& function) { return CalledRate{function}; }

int scene_emitter(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "emitter");
  std::vector<std::string_view> known = {"at",   "rate",   "velocity", "spread", "lifetime", "max",
                                         "mass", "radius", "color",    "look",   "enabled",  "name"};
  const FamilyOption family = family_option(state, 2, "emitter", known);
  const Options o(state, 2, "emitter", known);
  EmitterDef def;
  require(o.has("rate"), "emitter: rate must be given, a number [1/s] or a function of time");
  if (o.has("at")) {
    def.position = check_emitter_position(state, o.push("at"), "emitter");
    lua_pop(state, 1);
  }
  if (const int rate = o.push("rate"); lua_isfunction(state, rate))
    def.rate_at = rate_function(Callback(state, rate));
  else
    def.rate = check_number(state, rate, "emitter", "rate", "1/s");
  lua_pop(state, 1);
  if (o.has("lifetime")) {
    std::tie(def.shortest, def.longest) = check_lifetimes(state, o.push("lifetime"), "emitter");
    lua_pop(state, 1);
  }
  if (const auto max = o.number_or_infinity("max", "")) def.max = fields::most_of_number(*max);
  def.velocity = o.vector("velocity", "m/s").value_or(def.velocity);
  def.spread = o.number("spread", "rad").value_or(def.spread);
  def.family = family.id;
  def.mass = o.number("mass", "kg");
  take_looks(def, o, family.attributes);
  def.enabled = o.boolean("enabled").value_or(true);
  def.name = o.string("name").value_or("");
  push_thing(state, self.script, add_emitter(self.world, def));
  return 1;
}

}  // namespace pantin::lua
