// Numbers about the whole scene or a set of things, as Lua reads them.
#include <algorithm>
#include <cstring>

#include "articulates/articulate.hpp"
#include "choreography/choreography.hpp"
#include "forces/forces.hpp"
#include "forces/integrator.hpp"
#include "forces/sleep.hpp"
#include "lua/scene/choreography.hpp"
#include "lua/thing/fields.hpp"
#include "lua/thing/script.hpp"
#include "lua/value/arguments.hpp"
#include "lua/vm/guard.hpp"
#include "measure/ledger_closure.hpp"
#include "measure/measure.hpp"
#include "measure/query.hpp"

namespace pantin::lua {
namespace {

void set(lua_State* state, const char* name, double value) {
  lua_pushnumber(state, value);
  lua_setfield(state, -2, name);
}
void set(lua_State* state, const char* name, std::uint64_t value) {
  lua_pushinteger(state, static_cast<lua_Integer>(value));
  lua_setfield(state, -2, name);
}
void set(lua_State* state, const char* name, const std::string& value) {
  lua_pushlstring(state, value.data(), value.size());
  lua_setfield(state, -2, name);
}

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

void push_energy(lua_State* state, const Energy& energy) {
  lua_createtable(state, 0, 3);
  set(state, "kinetic", energy.kinetic);
  set(state, "potential", energy.potential);
  set(state, "total", energy.total());
}

Things members(const Self& self) { return things_of(self.world, any_of(self.ref)); }

void read_error(const Self& self) {
  const Accuracy now = accuracy(self.world);
  const Accuracy& worst = self.world.worst;
  lua_createtable(self.state, 0, 6);
  set(self.state, "hinge_gap", now.hinge_gap);
  set(self.state, "constraint", now.constraint);
  set(self.state, "energy", now.energy);
  set(self.state, "worst_hinge_gap", std::fmax(worst.hinge_gap, now.hinge_gap));
  set(self.state, "worst_constraint", std::fmax(worst.constraint, now.constraint));
  set(self.state, "worst_energy", std::fmax(worst.energy, now.energy));
}

void read_ledger(const Self& self) {
  const LawLedger ledger = law_ledger(self.world);
  lua_createtable(self.state, 0, 16);
  lua_newtable(self.state);
  for (const auto& [name, joules] : ledger.given) set(self.state, name.c_str(), joules);
  lua_setfield(self.state, -2, "laws");
  lua_newtable(self.state);
  for (std::size_t i = 0; i < ledger.without_energy.size(); i++) {
    lua_pushstring(self.state, ledger.without_energy[i].c_str());
    lua_rawseti(self.state, -2, static_cast<lua_Integer>(i + 1));
  }
  lua_setfield(self.state, -2, "without_energy");
  set(self.state, "open", ledger.open);
  const Ledger& kept = self.world.ledger;
  for (std::size_t i = 0; i < source_names.size(); i++)
    set(self.state, std::string(source_names[i]).c_str(), kept.given[i]);
  keep_old_name(self, "safe_step", "fallback_step");
  keep_ledger(self.world);
  if (!kept.kept) return;
  set(self.state, "since", kept.since);
  set(self.state, "gravity", kept.gravity);
  set(self.state, "closure", closure(self.world));
  lua_newtable(self.state);
  for (const auto& [name, joules] : truncation(self.world)) set(self.state, name.c_str(), joules);
  lua_setfield(self.state, -2, "truncation");
}

void read_stats(const Self& self) {
  const Stats& s = self.world.stats;
  lua_newtable(self.state);
  set(self.state, "steps", self.world.steps);
  set(self.state, "articulates", std::uint64_t{self.world.articulates.size()});
  set(self.state, "asleep", sleepers(self.world));
  set(self.state, "newton_iterations", s.newton_iterations);
  set(self.state, "worst_iterations", std::uint64_t{s.worst_iterations});
  set(self.state, "solves", s.solves);
  set(self.state, "factorisations", s.factorisations);
  set(self.state, "halved_steps", s.halved_steps);
  set(self.state, "fallback_steps", s.fallback_steps);
  set(self.state, "rejected_steps", s.rejected);
  set(self.state, "missed_accuracy", worst_missed(self.world));
  set(self.state, "projections", s.projections);
  set(self.state, "sub_steps", std::uint64_t{self.world.sub_steps.count});
  const MostSubSteps most = most_sub_steps(self.world);
  set(self.state, "most_sub_steps", std::uint64_t{most.count});
  lua_pushlstring(self.state, most.thing.data(), most.thing.size());
  lua_setfield(self.state, -2, "most_sub_steps_of");
  lua_newtable(self.state);
  for (std::size_t i = 0; i < phase_names.size(); i++)
    set(self.state, std::string(phase_names[i]).c_str(), static_cast<double>(self.world.profile.ns[i]));
  lua_setfield(self.state, -2, "ns");
  keep_old_name(self, "safe_steps", "fallback_steps");
}

void read_log(const Self& self) {
  const auto& log = self.world.log;
  lua_createtable(self.state, static_cast<int>(log.size()), 0);
  lua_Integer i = 0;
  for (const LogLine& line : log) {
    lua_createtable(self.state, 0, 3);
    set(self.state, "time", line.time);
    set(self.state, "kind", line.kind);
    set(self.state, "text", line.text);
    lua_rawseti(self.state, -2, ++i);
  }
}

std::vector<Field> thing_measures() {
  return {
      {"energy", "Energy", "J", "of its things",
       [](const Self& s) { push_energy(s.state, energy(s.world, members(s))); }, nullptr},
      {"momentum", "vec", "kg m/s", "sum over its things",
       [](const Self& s) { push(s.state, momentum(s.world, members(s))); }, nullptr},
      {"angular_momentum", "vec", "kg m²/s", "sum over its things about the world's origin",
       [](const Self& s) { push(s.state, angular_momentum(s.world, members(s))); }, nullptr},
      {"temperature", "number", "K", "of its things, relative to their common motion; in J while scene.boltzmann is 1",
       [](const Self& s) { lua_pushnumber(s.state, temperature(s.world, members(s))); }, nullptr},
      {"mass", "number", "kg", "sum over its things",
       [](const Self& s) { lua_pushnumber(s.state, mass(s.world, members(s))); }, nullptr},
  };
}

std::vector<Field> scene_measures() {
  return {
      {"time", "number", "s", "simulated time", [](const Self& s) { lua_pushnumber(s.state, s.world.time); }, nullptr},
      {"energy", "Energy", "J", "of all things", [](const Self& s) { push_energy(s.state, energy(s.world)); }, nullptr},
      {"momentum", "vec", "kg m/s", "sum over all things",
       [](const Self& s) { push(s.state, momentum(s.world, everything(s.world))); }, nullptr},
      {"angular_momentum", "vec", "kg m²/s", "sum over all things about the world's origin",
       [](const Self& s) { push(s.state, angular_momentum(s.world, everything(s.world))); }, nullptr},
      {"temperature", "number", "K", "relative to the common motion; in J while scene.boltzmann is 1",
       [](const Self& s) { lua_pushnumber(s.state, temperature(s.world, everything(s.world))); }, nullptr},
      {"error", "Accuracy", "", "what is left open now, and the worst since the start", read_error, nullptr},
      {"ledger", "Ledger", "J",
       "where energy came from and went since the start; the first reading has all of it kept from the next step on",
       read_ledger, nullptr},
      {"stats", "Stats", "", "counts since the start, and ns per phase", read_stats, nullptr},
      {"log", "LogLine[]", "", "all that was logged", read_log, nullptr},
      {"timeline", "TimelineEntry[]", "", "events that ended, then those that wait: the latest and the next 1000",
       [](const Self& s) { push_timeline(s.state, s.world); }, nullptr},
      {"bodies", "Body[]", "", "all bodies, in the order of making",
       [](const Self& s) { push_list(s.state, s.script, s.world.bodies.ids()); }, nullptr},
      {"particles", "Particle[]", "", "all particles that are no hinges, and do not sleep in one",
       [](const Self& s) { push_list(s.state, s.script, particles(s.world)); }, nullptr},
      {"hinges", "Particle[]", "", "all hinges", [](const Self& s) { push_list(s.state, s.script, hinges(s.world)); },
       nullptr},
      {"connections", "Connection[]", "", "all connections, in the order of making",
       [](const Self& s) { push_list(s.state, s.script, s.world.connections.ids()); }, nullptr},
  };
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
    Type made{"AnySet", "set of things", "What groups and families tell of their things.", thing_measures(), {}};
    made.base = &any_thing_type();
    return made;
  }();
  return type;
}

const Type& any_scene_type() {
  static const Type type = {"AnyScene",
                            "scene",
                            "What a scene tells of itself: to its script, and to a test that opened it.",
                            scene_measures(),
                            {{"find", guard<scene_find>, "name: string", "Thing?",
                              "The oldest living thing of that name.", "local found = scene:find(\"all\")"},
                             {"near", guard<scene_near>, "at: vec [m], radius: number [m]", "Particle[]",
                              "Particles within a radius, nearest first.",
                              "for _, other in ipairs(scene:near(p.position, 0.5)) do other:remove() end"}}};
  return type;
}

}  // namespace pantin::lua
