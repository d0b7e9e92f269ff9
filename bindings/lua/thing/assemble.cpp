#include "lua/thing/assemble.hpp"

#include <cmath>

#include "base/interruptible.hpp"
#include "edit/assemble.hpp"
#include "lua/thing/fields.hpp"
#include "lua/thing/force_element_options.hpp"
#include "lua/thing/script.hpp"
#include "lua/thing/targets.hpp"
#include "lua/value/arguments.hpp"
#include "lua/vm/guard.hpp"

namespace pantin::lua {
namespace {

/// A list of points, or points one after the other.
std::vector<PointId> check_points(lua_State* state, int index, const char* call) {
  std::vector<PointId> points;
  const auto take = [&](int at, const std::string& name) {
    points.push_back(check_kind(state, at, Kind::point, call, name).id<PointId>());
  };
  if (!lua_istable(state, index)) {
    for (int i = index; i <= lua_gettop(state); i++) take(i, argument(i - 1));
    return points;
  }
  const auto count = lua_rawlen(state, index);
  for (lua_Unsigned i = 1; i <= count; i++) {
    lua_rawgeti(state, index, static_cast<lua_Integer>(i));
    take(lua_gettop(state), text("element ", i, " of ", argument(index - 1)));
    lua_pop(state, 1);
  }
  return points;
}

/// Whether a table has keys that are texts.
bool has_names(lua_State* state, int table) {
  bool found = false;
  lua_pushnil(state);
  while (lua_next(state, table)) {
    found = found || lua_type(state, -2) == LUA_TSTRING;
    lua_pop(state, 1);
  }
  return found;
}

/// A whole number >= 0 that a double holds exactly.
std::optional<std::uint64_t> whole(const Options& o, const char* name) {
  const auto given = o.number(name, "");
  if (!given) return {};
  require(*given >= 0.0 && *given <= 9007199254740992.0 && std::trunc(*given) == *given, o.what(), ": ", name,
          " must be a whole number from 0 to 2^53, got ", *given);
  return static_cast<std::uint64_t>(*given);
}

GroupId group_of(const Self& self) { return self.ref.id<GroupId>(); }

}  // namespace

int scene_merge(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "merge");
  const BodyId a = check_body(state, 2, "merge", argument(1)), b = check_body(state, 3, "merge", argument(2));
  merge(self.world, a, b);
  push_thing(state, self.script, a);
  return 1;
}

int scene_split(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "split");
  const BodyId body = check_body(state, 2, "split", argument(1));
  if (lua_istable(state, 3) && has_names(state, 3)) {
    const Options o(state, 3, "split", {"through", "normal"});
    const auto through = o.vector("through", "m"), normal = o.vector("normal", "");
    require(through && normal, "split: a plane needs both, { through = vec [m], normal = vec }");
    push_thing(state, self.script, split(self.world, body, *through, *normal));
    return 1;
  }
  push_thing(state, self.script, split(self.world, body, check_points(state, 3, "split")));
  return 1;
}

int scene_freeze(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "freeze");
  const GroupId group = check_kind(state, 2, Kind::group, "freeze", argument(1)).id<GroupId>();
  push_thing(state, self.script, freeze(self.world, group));
  return 1;
}

int scene_shatter(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "shatter");
  const BodyId body = check_body(state, 2, "shatter", argument(1));
  if (lua_isnoneornil(state, 3)) {
    push_list(state, self.script, shatter(self.world, body));
    return 1;
  }
  const Options o(state, 3, "shatter", {"pieces", "seed", "at"});
  ShatterDef def;
  const auto pieces = whole(o, "pieces");
  require(pieces.has_value(),
          "shatter: needs pieces, the number of bodies; without a table the body's points become particles");
  def.pieces = *pieces;
  def.seed = whole(o, "seed").value_or(def.seed);
  def.at = o.vector("at", "m");
  push_list(state, self.script, shatter(self.world, body, def));
  return 1;
}

int scene_connect_within(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "connect_within");
  lua_settop(state, 5);
  const GroupId group = check_kind(state, 2, Kind::group, "connect_within", argument(1)).id<GroupId>();
  const double distance = check_number(state, 3, "connect_within", "argument 2, the distance,", "m");
  std::vector<ConnectionId> made;
  const std::size_t notices = self.world.notices.size();
  try {
    Interruptible loop;
    for (const auto& [a, b] : pairs_within(self.world, group, distance)) {
      made.push_back(connect(self, {{a, zero3()}, {b, zero3()}}, 4));
      loop.count(100);
    }
  } catch (...) {
    for (ConnectionId id : made) remove(self.world, id);
    self.world.notices.resize(notices);
    throw;
  }
  push_list(state, self.script, made);
  return 1;
}

int group_break_connections(lua_State* state) {
  const Self self = check_self(state, Kind::group, "break_connections");
  for (ConnectionId id : connections_in(self.world, group_of(self))) remove(self.world, id);
  return 0;
}

int group_heat(lua_State* state) {
  const Self self = check_self(state, Kind::group, "heat");
  heat(self.world, group_of(self), check_number(state, 2, "heat", "argument 1, the energy,", "J"));
  return 0;
}

}  // namespace pantin::lua
