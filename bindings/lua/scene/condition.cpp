// Conditions of `scene:when`: `{ temperature_above = 300, of = group }`.
#include "choreography/conditions.hpp"
#include "lua/scene/choreography.hpp"
#include "lua/thing/fields.hpp"
#include "lua/thing/script.hpp"
#include "lua/thing/script_functions.hpp"
#include "lua/thing/targets.hpp"
#include "lua/value/arguments.hpp"
#include "lua/vm/guard.hpp"

namespace pantin::lua {
namespace {

struct NamedQuantity {
  const char* name;
  Quantity quantity;
  const char* unit;
};
constexpr NamedQuantity quantities[] = {{"temperature", Quantity::temperature, "K"},
                                        {"energy", Quantity::energy, "J"},
                                        {"force", Quantity::force, "N"},
                                        {"distance", Quantity::distance, "m"},
                                        {"count", Quantity::count, ""}};

Whereabouts whereabouts_at(lua_State* state, int index, const std::string& name) {
  if (to_vec(state, index)) return {{}, check_vec(state, index, "when", name, "m")};
  const Ref* ref = to_ref(state, index);
  if (ref && ref->kind == Kind::scene) return {};
  return {check_thing(state, index, "when", name).thing};
}

/// A thing, a place, or a list of two of them.
std::vector<Whereabouts> check_of(const Options& o) {
  std::vector<Whereabouts> list;
  if (!o.has("of")) return list;
  lua_State* state = o.state();
  const int of = o.push("of");
  if (!lua_istable(state, of)) {
    list.push_back(whereabouts_at(state, of, "of"));
  } else {
    const auto count = lua_rawlen(state, of);
    for (lua_Unsigned i = 1; i <= count; i++) {
      lua_rawgeti(state, of, static_cast<lua_Integer>(i));
      list.push_back(whereabouts_at(state, lua_gettop(state), text("element ", i, " of `of`")));
      lua_pop(state, 1);
    }
  }
  lua_pop(state, 1);
  return list;
}

Measured of_table(lua_State* state, int index, const World& world) {
  std::vector<std::string> names, known;
  for (const NamedQuantity& q : quantities)
    for (const char* side : {"_above", "_below"}) names.push_back(std::string(q.name) + side);
  known = names;
  known.push_back("of");
  const Options o(state, index, "when", known);
  std::optional<Measured> found;
  for (const NamedQuantity& q : quantities)
    for (const bool above : {true, false}) {
      const std::string name = text(q.name, above ? "_above" : "_below");
      const auto limit = o.number(name.c_str(), q.unit);
      if (!limit) continue;
      require(!found, "when: a condition has one limit, got two; use a function for more");
      found = measured(world, q.quantity, check_of(o));
      found->limit = *limit;
      found->above = above;
    }
  require(found.has_value(), "when: a condition needs one of ", joined(names));
  return *found;
}

Measured of_function(lua_State* state, int index) {
  const Callback function = check_function(state, index, "when", "argument 1, the condition,");
  Measured m;
  m.limit = 0.5;
  m.measure = CalledCondition{function};
  return m;
}

}  // namespace

Measured check_condition(lua_State* state, int index, int options, Script& script) {
  const bool table = lua_istable(state, index);
  require(table || lua_isfunction(state, index),
          "when: argument 1, the condition, must be a function or a table such as { temperature_above = 300 }, got ",
          kind_of_value(state, index));
  Measured m = table ? of_table(state, index, script.world) : of_function(state, index);
  const Options o(state, options, "when", {"mean", "again", "hysteresis"});
  require(table || (!o.has("mean") && !o.has("hysteresis")),
          "when: mean and hysteresis are for what is measured; a function just says whether it holds");
  m.mean = o.number("mean", "s").value_or(0.0);
  m.hysteresis = o.number("hysteresis", "").value_or(0.0);
  m.again = o.boolean("again").value_or(false);
  return m;
}

}  // namespace pantin::lua
