// The table `force`: pair, point and many, for laws of a scene's own; force_library.cpp adds those of the library.
#include "lua/law/force.hpp"

#include <algorithm>
#include <cmath>

#include "laws/library.hpp"
#include "lua/law/force_library.hpp"
#include "lua/value/arguments.hpp"
#include "lua/value/tostring.hpp"
#include "lua/value/values.hpp"
#include "lua/vm/guard.hpp"
#include "lua/vm/runtime.hpp"

namespace pantin::lua {
namespace {

/// The userdata; the function, if it has one, is its user value.
struct LawData {
  Tag tag;
  std::shared_ptr<LawSpec> spec;
};

const char law_key = 0;

int law_text(lua_State* state) {
  const LawSpec& spec = *to_law(state, 1);
  const std::string s = text(spec.word, " law");
  lua_pushlstring(state, s.data(), s.size());
  return 1;
}

int law_index(lua_State*) { throw Error("a law has no fields; its parameters are those of what it is used in"); }
int law_change(lua_State*) { throw Error("a law cannot be changed; make a new one"); }

int drop_law(lua_State* state) {
  static_cast<LawData*>(lua_touserdata(state, 1))->spec.reset();
  return 0;
}

void push_law_metatable(lua_State* state) {
  if (lua_rawgetp(state, LUA_REGISTRYINDEX, &law_key) != LUA_TNIL) return;
  lua_pop(state, 1);
  lua_newtable(state);
  const luaL_Reg functions[] = {{"__tostring", guard<law_text>},
                                {"__index", guard<law_index>},
                                {"__newindex", guard<law_change>},
                                {"__gc", drop_law},
                                {nullptr, nullptr}};
  luaL_setfuncs(state, functions, 0);
  for (const char* field : {"__name", "__metatable"}) {
    lua_pushliteral(state, "law");
    lua_setfield(state, -2, field);
  }
  lua_pushvalue(state, -1);
  lua_rawsetp(state, LUA_REGISTRYINDEX, &law_key);
}

/// The one of the functions that is given.
LawForm read_function(const Options& o, std::initializer_list<std::pair<const char*, LawForm>> forms,
                      lua_State* state) {
  std::optional<LawForm> form;
  std::string names;
  for (const auto& [name, its_form] : forms) {
    names += (names.empty() ? "" : ", ") + std::string(name);
    if (!o.has(name)) continue;
    require(!form, o.what(), ": give one of ", names, ", not two");
    const int at = o.push(name);
    require(lua_isfunction(state, at) && !lua_iscfunction(state, at), o.what(), ": ", name,
            " must be a function of the scene, got ", kind_of_value(state, at));
    form = its_form;
  }
  require(form.has_value(), o.what(), ": needs ", forms.size() == 1 ? "" : "one of ", names, ", a function");
  return *form;
}

void read_parameters(lua_State* state, const Options& o, LawDef& def) {
  const int table = o.push("parameters");
  if (!lua_isnil(state, table)) {
    require(lua_istable(state, table), o.what(), ": parameters must be a table { name = number }, got ",
            kind_of_value(state, table));
    const KeysOfTable keys = keys_of(state, table);
    require(keys.count == 0 && !keys.has_others, o.what(), ": parameters must have names");
    for (const std::string& name : keys.names) {
      lua_pushlstring(state, name.data(), name.size());
      lua_rawget(state, table);
      def.parameters.push_back(
          {name, check_number(state, lua_gettop(state), o.what(), text("parameter '", name, "'"), ""), ""});
      lua_pop(state, 1);
    }
  }
  lua_pop(state, 1);
}

void read_common(lua_State* state, const Options& o, LawSpec& spec) {
  read_parameters(state, o, spec.def);
  spec.strict = o.boolean("strict").value_or(false);
  spec.exact = o.boolean("exact").value_or(true);
  spec.def.name = o.string("name").value_or("");
}

void read_range(const Options& o, LawSpec& spec) {
  const PairOptions pair = read_pair_options(o);
  require(!pair.shift || spec.form == LawForm::pair_potential, o.what(), ": shift is for a potential");
  require(!pair.shift || std::isfinite(pair.cutoff), o.what(), ": shift is for a law with a cutoff");
  spec.def.cutoff = pair.cutoff;
  spec.def.shift = pair.shift.value_or(true);
  spec.def.one_sided = pair.one_sided;
  spec.def.exclude = pair.exclude;
  spec.solve = pair.solve;
  require(spec.solve == Solve::explicitly || spec.form != LawForm::pair_force, o.what(),
          ": implicit is for a potential or a tension, whose derivative is known");
}

/// The function is below the top.
int push_own_law(lua_State* state, LawSpec spec) {
  push_law(state, std::move(spec));
  lua_insert(state, -2);
  lua_setiuservalue(state, -2, 1);
  return 1;
}

int force_pair(lua_State* state) {
  check_count(state, 1, "force.pair");
  const Options o(state, 1, "force.pair",
                  {"potential", "tension", "force", "cutoff", "shift", "one_sided", "exclude", "parameters", "strict",
                   "exact", "implicit", "name"});
  LawSpec spec;
  spec.word = o.what();
  spec.form = read_function(
      o, {{"potential", LawForm::pair_potential}, {"tension", LawForm::pair_tension}, {"force", LawForm::pair_force}},
      state);
  spec.kind = spec.form == LawForm::pair_force ? LawKind::pair : LawKind::central;
  read_common(state, o, spec);
  read_range(o, spec);
  return push_own_law(state, std::move(spec));
}

int force_point(lua_State* state) {
  check_count(state, 1, "force.point");
  const Options o(state, 1, "force.point", {"potential", "force", "parameters", "strict", "exact", "name"});
  LawSpec spec;
  spec.word = o.what();
  spec.form = read_function(o, {{"potential", LawForm::point_potential}, {"force", LawForm::point_force}}, state);
  spec.kind = LawKind::point;
  spec.count = 1;
  read_common(state, o, spec);
  return push_own_law(state, std::move(spec));
}

int force_many(lua_State* state) {
  check_count(state, 1, "force.many");
  const Options o(state, 1, "force.many", {"count", "potential", "parameters", "strict", "exact", "name"});
  LawSpec spec;
  spec.word = o.what();
  const double count = o.number("count", "").value_or(0.0);
  require(count == 2 || count == 3 || count == 4, o.what(), ": count must be 2, 3 or 4, got ",
          o.has("count") ? to_text(count) : "nil");
  spec.count = static_cast<int>(count);
  spec.kind = LawKind::many;
  spec.form = read_function(o, {{"potential", LawForm::many_potential}}, state);
  read_common(state, o, spec);
  return push_own_law(state, std::move(spec));
}

int unknown_law(lua_State* state) {
  std::vector<std::string> names = {"pair", "point", "many"};
  for (const LibraryLaw& law : library()) names.push_back(law.name);
  const std::string name(push_text(state, 2));
  throw Error(text("force: unknown law '", name, "'.", suggestion(name, names), " Known are ", joined(names)));
}

}  // namespace

PairOptions read_pair_options(const Options& o) {
  PairOptions pair;
  pair.cutoff = o.number_or_infinity("cutoff", "m").value_or(pair.cutoff);
  require(pair.cutoff > 0, o.what(), ": cutoff must be > 0 m, got ", pair.cutoff);
  pair.shift = o.boolean("shift");
  pair.one_sided = o.boolean("one_sided").value_or(false);
  const double exclude = o.number("exclude", "").value_or(0.0);
  require(exclude >= 0 && exclude <= 8 && exclude == std::floor(exclude), o.what(),
          ": exclude must be a whole number from 0 to 8, got ", exclude);
  pair.exclude = static_cast<int>(exclude);
  pair.solve = read_implicit(o);
  return pair;
}

Solve read_implicit(const Options& o) {
  if (!o.has("implicit")) return Solve::explicitly;
  const int at = o.push("implicit");
  const bool is_boolean = lua_isboolean(o.state(), at), on = lua_toboolean(o.state(), at) != 0;
  const std::string given = lua_type(o.state(), at) == LUA_TSTRING ? lua_tostring(o.state(), at) : "";
  const bool dissipative = given == "dissipative";
  std::string got;
  if (!is_boolean && !dissipative) got = given.empty() ? kind_of_value(o.state(), at) : text("\"", given, "\"");
  lua_pop(o.state(), 1);
  require(got.empty(), o.what(), ": implicit must be true, false or \"dissipative\", got ", got);
  return dissipative ? Solve::at_end : on ? Solve::at_middle : Solve::explicitly;
}

void push_law(lua_State* state, LawSpec spec) {
  auto shared = std::make_shared<LawSpec>(std::move(spec));
  new (lua_newuserdatauv(state, sizeof(LawData), 1)) LawData{Tag::law, std::move(shared)};
  push_law_metatable(state);
  lua_setmetatable(state, -2);
}

LawSpec* to_law(lua_State* state, int index) {
  if (tag_of(state, index) != Tag::law) return nullptr;
  return static_cast<LawData*>(lua_touserdata(state, index))->spec.get();
}

void open_force(lua_State* state) {
  lua_newtable(state);
  const luaL_Reg functions[] = {
      {"pair", guard<force_pair>}, {"point", guard<force_point>}, {"many", guard<force_many>}, {nullptr, nullptr}};
  luaL_setfuncs(state, functions, 0);
  add_library_laws(state);
  lua_newtable(state);
  lua_pushcfunction(state, guard<unknown_law>);
  lua_setfield(state, -2, "__index");
  lua_setmetatable(state, -2);
  lua_setglobal(state, "force");
}

}  // namespace pantin::lua
