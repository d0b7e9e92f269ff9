#include "lua/law/law_run.hpp"

#include <algorithm>
#include <utility>

#include "lua/value/arguments.hpp"
#include "lua/value/tostring.hpp"
#include "lua/value/values.hpp"
#include "lua/vm/guard.hpp"
#include "lua/vm/runtime.hpp"

namespace pantin::lua {
namespace {

using Seen = LawRun::Seen;

struct LawParticle {
  Tag tag;
  int who;
};

const char particle_key = 0, own_key = 0, list_key = 0;

LawRun& running(lua_State* state) {
  LawRun* run = Runtime::of(state).law;
  require(run, "this is an argument of a law, and lives only while the law's function runs");
  return *run;
}

/// Of the field that is asked for; it may be left at the top.
std::string_view key_text(lua_State* state) {
  return lua_type(state, 2) == LUA_TSTRING ? lua_tostring(state, 2) : push_text(state, 2);
}

/// Place and velocity, where the form of law may see them.
bool push_motion(lua_State* state, LawRun& run, int who, std::string_view name) {
  if (name != "position" && name != "velocity") return false;
  const LawForm form = run.law.form;
  if (form == LawForm::pair_force)
    run.mistake(state,
                text("a law of a pair sees no ", name, " but d and u, position and velocity of b relative to a"));
  if (is_pair(form))
    run.mistake(state, text("a law of the distance sees no ", name, "; give force = function(d, u, a, b, own, t)"));
  if (name == "velocity" && is_potential(form))
    run.mistake(state, "a potential cannot depend on velocity; give a force");
  run.push(state, name == "position" ? Seen::place : Seen::velocity, who);
  return true;
}

int particle_index(lua_State* state) {
  LawRun& run = running(state);
  const int who = static_cast<const LawParticle*>(lua_touserdata(state, 1))->who;
  const std::string_view name = key_text(state);
  if (push_motion(state, run, who, name)) return 1;
  const KnownNames& known = run.law.known[static_cast<std::size_t>(who)];
  const std::ptrdiff_t found = known.find(name);
  if (found < 0) {
    std::vector<std::string> names = known.all();
    if (known.place)
      run.mistake(state,
                  text(known.whose, " has no '", name, "'; a law between a particle and a position cannot read it"));
    const LawForm form = run.law.form;
    if (!is_pair(form)) names.insert(names.begin(), "position");
    if (form == LawForm::point_force) names.insert(names.begin() + 1, "velocity");
    run.mistake(state, text(known.whose, " has no attribute '", name, "'.", suggestion(std::string(name), names),
                            " It has ", joined(names)));
  }
  run.push_attribute(state, who, static_cast<std::size_t>(found));
  return 1;
}

int own_index(lua_State* state) {
  LawRun& run = running(state);
  const std::string_view name = key_text(state);
  const std::vector<Parameter>& parameters = run.law.def.parameters;
  const auto found =
      std::find_if(parameters.begin(), parameters.end(), [&](const Parameter& p) { return p.name == name; });
  if (found == parameters.end()) {
    std::vector<std::string> names;
    for (const Parameter& p : parameters) names.push_back(p.name);
    run.mistake(state, text("the law has no parameter '", name, "'.", suggestion(std::string(name), names),
                            names.empty() ? text(" It has none; give parameters = { ", name, " = … }")
                                          : text(" It has ", joined(names))));
  }
  run.push_parameter(state, static_cast<std::size_t>(found - parameters.begin()));
  return 1;
}

int list_index(lua_State* state) {
  LawRun& run = running(state);
  run.mistake(state, text("the particles of this law are a list of ", run.law.count, ", p[1] to p[", run.law.count,
                          "], which has no '", key_text(state), "'"));
}

int refuse_write(lua_State* state) {
  running(state).mistake(state, "a law reads its arguments and returns; it cannot write to them");
}

void push_metatable(lua_State* state, const void* key, const char* name, lua_CFunction index) {
  if (lua_rawgetp(state, LUA_REGISTRYINDEX, key) != LUA_TNIL) return;
  lua_pop(state, 1);
  lua_newtable(state);
  const luaL_Reg functions[] = {{"__index", index}, {"__newindex", guard<refuse_write>}, {nullptr, nullptr}};
  luaL_setfuncs(state, functions, 0);
  for (const char* field : {"__name", "__metatable"}) {
    lua_pushstring(state, name);
    lua_setfield(state, -2, field);
  }
  lua_pushvalue(state, -1);
  lua_rawsetp(state, LUA_REGISTRYINDEX, key);
}

void push_particle(lua_State* state, int who) {
  *static_cast<LawParticle*>(lua_newuserdatauv(state, sizeof(LawParticle), 0)) = {Tag::law_particle, who};
  push_metatable(state, &particle_key, "particle of a law", guard<particle_index>);
  lua_setmetatable(state, -2);
}

void push_own(lua_State* state) {
  *static_cast<Tag*>(lua_newuserdatauv(state, sizeof(Tag), 0)) = Tag::law_own;
  push_metatable(state, &own_key, "parameters of a law", guard<own_index>);
  lua_setmetatable(state, -2);
}

void push_particles(lua_State* state, int count) {
  lua_createtable(state, count, 0);
  for (int who = 0; who < count; who++) {
    push_particle(state, who);
    lua_rawseti(state, -2, who + 1);
  }
  push_metatable(state, &list_key, "list of particles", guard<list_index>);
  lua_setmetatable(state, -2);
}

int noise(lua_State* state) {
  LawRun* run = Runtime::of(state).law;
  require(run, "noise: may be called only inside the function of a law");
  if (run->noises >= 16) run->mistake(state, "noise: at most 16 calls in one law");
  run->push_noise(state, run->noises++);
  return 1;
}

int where_chosen(lua_State* state) {
  require(lua_isboolean(state, 1), "where: argument 1, the condition, must be true or false, got ",
          kind_of_value(state, 1));
  require(lua_gettop(state) == 3, "where: takes a condition and two values, got ", lua_gettop(state), " values");
  lua_pushvalue(state, lua_toboolean(state, 1) ? 2 : 3);
  return 1;
}

}  // namespace

const std::vector<std::string>& common_attributes() {
  static const std::vector<std::string> names = {"mass", "radius", "age", "lifetime"};
  return names;
}

std::vector<std::string> KnownNames::all() const {
  if (place) return {};
  std::vector<std::string> names = common_attributes();
  names.insert(names.end(), attributes.begin(), attributes.end());
  return names;
}

std::ptrdiff_t KnownNames::find(std::string_view name) const {
  if (place) return -1;
  const std::vector<std::string>& common = common_attributes();
  const auto first = std::find(common.begin(), common.end(), name);
  if (first != common.end()) return first - common.begin();
  const auto own = std::find(attributes.begin(), attributes.end(), name);
  return own == attributes.end() ? -1 : std::ssize(common) + (own - attributes.begin());
}

void LawRun::mistake(lua_State* state, const std::string& text) {
  const std::string place = lua::where(state);
  if (mistook.empty()) mistook = place.empty() ? text : pantin::text(place, ": ", text);
  throw ScriptError(mistook);
}

InLaw::InLaw(Runtime& runtime, LawRun& run) : runtime_(runtime), previous_(std::exchange(runtime.law, &run)) {}
InLaw::~InLaw() { runtime_.law = previous_; }

LawCall::LawCall(lua_State* state, LawRun& run) : state_(state), run_(run), base_(lua_gettop(state) + 1) {
  luaL_checkstack(state, 16, nullptr);
  run.law.function.push(state);
  push_own(state);
  if (run.law.form == LawForm::many_potential) {
    push_particles(state, run.law.count);
    return;
  }
  for (int who = 0; who < run.law.count; who++) push_particle(state, who);
}

void LawCall::call() {
  run_.noises = 0;
  lua_pushvalue(state_, base_);
  const LawForm form = run_.law.form;
  if (is_curve(form)) {
    for (const char* name : {"age", "lifetime"})
      run_.push_attribute(state_, 0, static_cast<std::size_t>(run_.law.known[0].find(name)));
    return lua_call(state_, 2, 1);
  }
  if (form == LawForm::pair_force) {
    run_.push(state_, Seen::displacement);
    run_.push(state_, Seen::relative_velocity);
  } else if (is_pair(form)) {
    run_.push(state_, Seen::distance);
    if (form == LawForm::pair_tension) run_.push(state_, Seen::rate);
  }
  lua_pushvalue(state_, base_ + 2);
  if (is_pair(form)) lua_pushvalue(state_, base_ + 3);
  lua_pushvalue(state_, base_ + 1);
  run_.push(state_, Seen::time);
  const int arguments[] = {5, 6, 6, 3, 3, 3};
  lua_call(state_, arguments[static_cast<int>(form)], 1);
}

void forbid_in_law(lua_State* state, const char* what, const char* instead) {
  if (LawRun* run = Runtime::of(state).law)
    run->mistake(state, text(what, " is not for laws, which must give the same in every run; write ", instead));
}

void open_law_run(lua_State* state) {
  lua_register(state, "noise", guard<noise>);
  lua_register(state, "where", guard<where_chosen>);
}

}  // namespace pantin::lua
