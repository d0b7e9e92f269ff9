#include "lua/law/force_library.hpp"

#include <cmath>
#include <map>

#include "laws/library.hpp"
#include "lua/value/arguments.hpp"
#include "lua/value/values.hpp"
#include "lua/vm/guard.hpp"

namespace pantin::lua {
namespace {

using Given = LibraryParameter::Given;
using Laws = std::vector<std::shared_ptr<const Law>>;

struct Known {
  Tag tag = Tag::known_laws;
  KnownLaws laws;
};
const char known_key = 0;  // of the registry

int drop_known(lua_State* state) {
  static_cast<Known*>(lua_touserdata(state, 1))->~Known();
  return 0;
}

bool is_of_pairs(const LibraryLaw& law) { return law.kind == LawKind::central || law.kind == LawKind::pair; }
bool is_table(const LibraryLaw& law) { return std::string_view(law.name) == "table"; }

std::vector<std::string> option_names(const LibraryLaw& law) {
  std::vector<std::string> names;
  for (const LibraryParameter& p : law.parameters)
    if (p.given != Given::world) names.push_back(p.name);
  if (is_table(law)) names.insert(names.end(), {"distances", "potentials", "tensions"});
  if (is_of_pairs(law)) names.insert(names.end(), {"cutoff", "shift", "one_sided", "exclude", "implicit"});
  names.push_back("name");
  return names;
}

std::vector<double> read_list(lua_State* state, const Options& o, const char* name, const char* unit) {
  std::vector<double> values;
  const int list = o.push(name);
  if (!lua_isnil(state, list)) {
    require(lua_istable(state, list), o.what(), ": ", name, " must be a list of numbers [", unit, "], got ",
            kind_of_value(state, list));
    const auto count = static_cast<lua_Integer>(lua_rawlen(state, list));
    for (lua_Integer i = 1; i <= count; i++) {
      lua_rawgeti(state, list, i);
      values.push_back(check_number(state, lua_gettop(state), o.what(), text(name, "[", i, "]"), unit));
      lua_pop(state, 1);
    }
  }
  lua_pop(state, 1);
  return values;
}

LawArguments read_arguments(lua_State* state, const Options& o, const LibraryLaw& law) {
  LawArguments arguments;
  for (const LibraryParameter& p : law.parameters) {
    const char* unit = std::string_view(p.unit) == "1" ? "" : p.unit;
    if (p.given == Given::world) continue;
    if (p.is_vector) {
      if (const auto v = o.vector(p.name, unit)) arguments.vectors[p.name] = *v;
    } else if (const auto x = o.number(p.name, unit)) {
      arguments.numbers[p.name] = *x;
    }
  }
  if (is_table(law)) {
    arguments.distances = read_list(state, o, "distances", "m");
    arguments.potentials = read_list(state, o, "potentials", "J");
    arguments.tensions = read_list(state, o, "tensions", "N");
  }
  if (!is_of_pairs(law)) return arguments;
  const PairOptions pair = read_pair_options(o);
  if (o.has("cutoff")) arguments.cutoff = pair.cutoff;
  arguments.shift = pair.shift.value_or(true);
  arguments.one_sided = pair.one_sided;
  arguments.exclude = pair.exclude;
  return arguments;
}

/// Whether the law itself depends on the values of its parameters, as by a cutoff that was not given.
bool depends_on_values(const LibraryLaw& law, const LawArguments& arguments, const Laws& made) {
  if (is_table(law) || (!arguments.cutoff && std::isfinite(made[0]->cutoff))) return true;
  for (const LibraryParameter& p : law.parameters)
    if (p.given == Given::optional && std::isnan(p.value) && !arguments.numbers.contains(p.name)) return true;
  return false;
}

/// What laws of this name and shape have in common.
std::string shape_of(const LibraryLaw& law, const LawArguments& arguments, const std::string& name) {
  std::string shape = text(law.name, "|", name, "|", arguments.cutoff.value_or(0.0), "|", arguments.shift, "|",
                           arguments.one_sided, "|", arguments.exclude);
  for (const auto& number : arguments.numbers) shape += "|" + number.first;
  return shape;
}

std::string values_of(const LawArguments& arguments) {
  std::string values = "=";
  for (const auto& number : arguments.numbers) values += text("|", number.second);
  return values;
}

Laws make_laws(const LibraryLaw& law, const LawArguments& arguments, const std::string& name) {
  Laws laws;
  std::vector<Law> parts = make_library_law(law.name, arguments);
  for (std::size_t i = parts.size(); i-- > 0;) {
    if (!name.empty()) parts[i].name = name;
    if (!laws.empty()) parts[i].also = laws.front();
    laws.insert(laws.begin(), std::make_shared<const Law>(std::move(parts[i])));
  }
  return laws;
}

/// The shared laws for some arguments. Shapes whose laws depend on values are marked by an empty entry.
Laws find_laws(KnownLaws& known, const LibraryLaw& law, const LawArguments& arguments, const std::string& name) {
  const std::string shape = shape_of(law, arguments, name);
  auto found = known.find(shape);
  if (found != known.end() && found->second.empty()) found = known.find(shape + values_of(arguments));
  if (found != known.end() && !is_table(law)) {
    check_law_arguments(law, arguments);
    return found->second;
  }
  Laws made = make_laws(law, arguments, name);
  if (is_table(law)) return made;
  const bool by_value = depends_on_values(law, arguments, made);
  if (by_value) known[shape] = {};
  known[by_value ? shape + values_of(arguments) : shape] = made;
  return made;
}

std::vector<double> parameter_values(const Law& law, const LawArguments& arguments) {
  std::vector<double> values;
  for (const pantin::Parameter& p : law.parameters) {
    double value = p.value;
    if (const auto number = arguments.numbers.find(p.name); number != arguments.numbers.end()) value = number->second;
    const std::string_view name = p.name;
    if (name.size() > 2 && name[name.size() - 2] == '_')
      if (const auto v = arguments.vectors.find(std::string(name.substr(0, name.size() - 2)));
          v != arguments.vectors.end())
        value = v->second[name.back() - 'x'];
    values.push_back(value);
  }
  return values;
}

/// Upvalues: the law of the library, the laws that were made so far.
int make_law(lua_State* state) {
  const auto& law = *static_cast<const LibraryLaw*>(lua_touserdata(state, lua_upvalueindex(1)));
  Known& known = *static_cast<Known*>(lua_touserdata(state, lua_upvalueindex(2)));
  LawSpec spec;
  spec.word = text("force.", law.name);
  spec.kind = law.kind;
  spec.count = law.count;
  check_count(state, 1, spec.word);
  const Options o(state, 1, spec.word, option_names(law));
  const LawArguments arguments = read_arguments(state, o, law);
  if (is_of_pairs(law)) spec.solve = read_pair_options(o).solve;
  require(spec.solve == Solve::explicitly || law.kind == LawKind::central, o.what(),
          ": implicit is for laws of the distance");
  ResolvedLaw resolved;
  try {
    resolved.laws = find_laws(known.laws, law, arguments, o.string("name").value_or(""));
  } catch (const Error& error) { throw Error(text("force.", error.what())); }
  resolved.values = parameter_values(*resolved.laws[0], arguments);
  resolved.solve = spec.solve;
  spec.library = std::move(resolved);
  push_law(state, std::move(spec));
  return 1;
}

}  // namespace

KnownLaws& known_laws(lua_State* state) {
  lua_rawgetp(state, LUA_REGISTRYINDEX, &known_key);
  Known& known = *static_cast<Known*>(lua_touserdata(state, -1));
  lua_pop(state, 1);
  return known.laws;
}

void add_library_laws(lua_State* state) {
  new (lua_newuserdatauv(state, sizeof(Known), 0)) Known;
  lua_newtable(state);
  lua_pushcfunction(state, drop_known);
  lua_setfield(state, -2, "__gc");
  lua_setmetatable(state, -2);
  lua_pushvalue(state, -1);
  lua_rawsetp(state, LUA_REGISTRYINDEX, &known_key);
  for (const LibraryLaw& law : library()) {
    lua_pushlightuserdata(state, const_cast<LibraryLaw*>(&law));
    lua_pushvalue(state, -2);
    lua_pushcclosure(state, guard<make_law>, 2);
    lua_setfield(state, -3, law.name);
  }
  lua_pop(state, 1);
}

}  // namespace pantin::lua
