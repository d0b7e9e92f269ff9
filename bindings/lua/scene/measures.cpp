// Numbers about the whole scene or a set of things, as Lua reads them.
#include <algorithm>
#include <cstring>

#include "choreography/choreography.hpp"
#include "lua/scene/touch_methods.hpp"
#include "lua/thing/fields.hpp"
#include "lua/thing/property_values.hpp"
#include "lua/thing/script.hpp"
#include "lua/value/arguments.hpp"
#include "lua/vm/guard.hpp"
#include "measure/query.hpp"

namespace pantin::lua {
namespace {

/// Answers t[old] with t[now], and says once what the name is now. Upvalues: the world, the two names.
int read_old_name(lua_State* state) {
  const char* old = lua_tostring(state, lua_upvalueindex(2));
  if (lua_type(state, 2) != LUA_TSTRING || std::strcmp(lua_tostring(state, 2), old) != 0) return 0;
  const char* now = lua_tostring(state, lua_upvalueindex(3));
  World& world = *static_cast<World*>(lua_touserdata(state, lua_upvalueindex(1)));
  const std::string notice = text("'", old, "' is called '", now, "' now");
  const auto is_it = [&](const LogLine& line) { return line.text == notice; };
  if (std::none_of(world.log.begin(), world.log.end(), is_it)) log_line(world, "notice", notice);
  lua_getfield(state, 1, now);
  return 1;
}

/// The table on top of the stack answers to an old name of a field, too.
void keep_old_name(const Self& self, const char* old, const char* now) {
  lua_createtable(self.state, 0, 1);
  lua_pushlightuserdata(self.state, &self.world);
  lua_pushstring(self.state, old);
  lua_pushstring(self.state, now);
  lua_pushcclosure(self.state, read_old_name, 3);
  lua_setfield(self.state, -2, "__index");
  lua_setmetatable(self.state, -2);
}

void push_property(const Self& self, const char* name) {
  push_value(self.state, self.script, fields::read(self.world, {}, name));
}

void read_ledger(const Self& self) {
  push_property(self, "ledger");
  keep_old_name(self, "safe_step", "fallback_step");
  keep_ledger(self.world);
}

void read_contact_heat(const Self& self) {
  push_property(self, "contact_heat");
  self.world.contacts.heat_kept = true;
}

void read_stats(const Self& self) {
  push_property(self, "stats");
  keep_old_name(self, "safe_steps", "fallback_steps");
}

int scene_find(lua_State* state) {
  const Ref* ref = to_ref(state, 1);
  require(ref && ref->kind == Kind::scene, "scene: call find with a colon, scene:find(…)");
  push_thing(state, *ref->script, find(ref->script->world, check_text(state, 2, "find", "argument 1, the name,")));
  return 1;
}

int scene_near(lua_State* state) {
  const Ref* ref = to_ref(state, 1);
  require(ref && ref->kind == Kind::scene, "scene: call near with a colon, scene:near(…)");
  const Vec3 at = check_vec(state, 2, "near", "argument 1, the position,", "m");
  const double radius = check_number_or_infinity(state, 3, "near", "argument 2, the radius,", "m");
  require(radius >= 0, "near: argument 2, the radius, must be >= 0 m, got ", radius);
  push_list(state, *ref->script, near(ref->script->world, at, radius));
  return 1;
}

}  // namespace

const Type& any_set_type() {
  static const Type type = [] {
    Type made = type_with(fields::any_set_type());
    field_named(made, "energy").read = read_energy;
    made.base = &any_thing_type();
    return made;
  }();
  return type;
}

const Type& any_scene_type() {
  static const Type type = [] {
    Type made = type_with(fields::any_scene_type());
    field_named(made, "energy").read = read_energy;
    field_named(made, "ledger").read = read_ledger;
    field_named(made, "contact_heat").read = read_contact_heat;
    field_named(made, "stats").read = read_stats;
    made.methods = {{"find", guard<scene_find>, "name: string", "Thing?", "The oldest living thing of that name.",
                     "local found = scene:find(\"all\")"},
                    {"near", guard<scene_near>, "at: vec [m], radius: number [m]", "Particle[]",
                     "Particles within a radius, nearest first.",
                     "for _, other in ipairs(scene:near(p.position, 0.5)) do other:remove() end"}};
    for (Method& method : hit_methods()) made.methods.push_back(method);
    return made;
  }();
  return type;
}

}  // namespace pantin::lua
