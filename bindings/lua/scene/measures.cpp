// Numbers about the whole scene or a set of things, as Lua reads them.
#include <cmath>

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

void push_property(const Self& self, const char* name) {
  push_value(self.state, self.script, fields::read(self.world, {}, name));
}

void read_ledger(const Self& self) {
  push_property(self, "ledger");
  lock_copy(self.state, "scene", "ledger", false);
  keep_ledger(self.world);
}

void read_contact_heat(const Self& self) {
  push_property(self, "contact_heat");
  self.world.contacts.heat_kept = true;
}

void read_stats(const Self& self) {
  push_property(self, "stats");
  lock_copy(self.state, "scene", "stats", false);
}

int scene_find(lua_State* state) {
  const Ref* ref = to_ref(state, 1);
  require(ref && ref->kind == Kind::scene, "scene: call find with a colon, scene:find(…)");
  const World& world = ref->script->world;
  if (lua_type(state, 2) == LUA_TNUMBER) {
    const double number = lua_tonumber(state, 2);
    require(number >= 1.0 && number == std::floor(number) && number < 0x1p53,
            "find: argument 1, the number of a thing, must be a whole one from 1 to 9e15, got ", number);
    push_thing(state, *ref->script, find_numbered(world, static_cast<std::uint64_t>(number)));
  } else {
    require(lua_type(state, 2) == LUA_TSTRING, "find: argument 1 must be a name, or the number of a thing, got ",
            kind_of_value(state, 2));
    push_thing(state, *ref->script, find(world, check_text(state, 2, "find", "argument 1, the name,")));
  }
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
    made.methods = {
        {"find", guard<scene_find>, "name: string|integer", "Thing?",
         "The oldest living thing of that name; or the living one of that number, by which messages call what "
         "has no name, as \"body 11\": all kinds of things are counted together, in the order of making.",
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
