#include <algorithm>
#include <unordered_set>

#include "edit/assemble.hpp"
#include "edit/edit.hpp"
#include "lua/thing/assemble.hpp"
#include "lua/thing/fields.hpp"
#include "lua/thing/script.hpp"
#include "lua/thing/targets.hpp"
#include "lua/value/arguments.hpp"
#include "lua/vm/guard.hpp"
#include "measure/measure.hpp"
#include "measure/query.hpp"

namespace pantin::lua {
namespace {

GroupId group_id(const Self& self) { return self.ref.id<GroupId>(); }

std::vector<AnyId> living_members(const Self& self) {
  std::vector<AnyId> living;
  for (const AnyId& id : self.world.groups[group_id(self)].members)
    if (alive(self.world, id)) living.push_back(id);
  return living;
}

int add_things(lua_State* state) {
  const Self self = check_self(state, Kind::group, "add");
  const int count = lua_gettop(state);
  for (int i = 2; i <= count; i++) check_thing(state, i, "group: add", argument(i - 1));
  require(count > 1, "group: add: argument 1 must be a thing of the scene, got nil");
  for (int i = 2; i <= count; i++) add_to_group(self.world, group_id(self), to_ref(state, i)->thing);
  lua_settop(state, 1);
  return 1;
}

/// `remove()` takes the set itself out of the world, `remove(thing)` a thing out of the set.
int remove_things(lua_State* state) {
  const Self self = check_self(state, Kind::group, "remove");
  const int count = lua_gettop(state);
  if (count == 1) return remove(self.world, group_id(self)), 0;
  for (int i = 2; i <= count; i++)
    remove_from_group(self.world, group_id(self), check_thing(state, i, "group: remove", argument(i - 1)).thing);
  return 0;
}

int count_members(lua_State* state) {
  const Self self = check_self(state, Kind::group, "#");
  lua_pushinteger(state, static_cast<lua_Integer>(living_members(self).size()));
  return 1;
}

/// Upvalues: the list and the place in it. Things that went meanwhile are left out.
int next_member(lua_State* state) {
  for (;;) {
    const lua_Integer i = lua_tointeger(state, lua_upvalueindex(2)) + 1;
    lua_pushinteger(state, i);
    lua_copy(state, -1, lua_upvalueindex(2));
    if (lua_rawgeti(state, lua_upvalueindex(1), i) == LUA_TNIL) return 1;
    if (alive(*to_ref(state, -1))) return 1;
    lua_pop(state, 2);
  }
}

int each_member(lua_State* state) {
  const Self self = check_self(state, Kind::group, "each");
  push_list(state, self.script, living_members(self));
  lua_pushinteger(state, 0);
  lua_pushcclosure(state, guard<next_member>, 2);
  return 1;
}

/// Hinges that are members, and those between two members; of groups in the group, too.
std::vector<ParticleId> hinges_in(const Self& self) {
  const std::vector<AnyId> members = all_members(self.world, group_id(self));
  std::vector<ParticleId> found;
  std::unordered_set<ParticleId> known;
  const auto keep = [&](ParticleId hinge) {
    if (self.world.particles[hinge].is_hinge() && known.insert(hinge).second) found.push_back(hinge);
  };
  std::vector<BodyId> bodies;
  for (const AnyId& id : members) {
    if (const auto* particle = std::get_if<ParticleId>(&id)) keep(*particle);
    if (const auto* body = std::get_if<BodyId>(&id)) bodies.push_back(*body);
  }
  std::sort(bodies.begin(), bodies.end());
  for (const AnyId& id : members) {
    const auto* body = std::get_if<BodyId>(&id);
    if (!body) continue;
    for (ParticleId hinge : hinges_of(self.world, *body)) {
      int inside = 0;
      for (PointId p : self.world.particles[hinge].points)
        if (std::binary_search(bodies.begin(), bodies.end(), self.world.points[p].body)) inside++;
      if (inside > 1) keep(hinge);
    }
  }
  return found;
}

int cut_hinges(lua_State* state) {
  const Self self = check_self(state, Kind::group, "cut_hinges");
  for (ParticleId hinge : hinges_in(self))
    if (self.world.particles.alive(hinge)) cut(self.world, hinge);
  return 0;
}

int move_things(lua_State* state) {
  const Self self = check_self(state, Kind::group, "move");
  const Vec3 by = check_vec(state, 2, "group: move", argument(1), "m");
  const Quat turn = lua_isnoneornil(state, 3) ? Quat{} : check_quat(state, 3, "group: move", argument(2));
  move(self.world, things_of(self.world, group_id(self)), by, turn);
  lua_settop(state, 1);
  return 1;
}

int bounds_of(lua_State* state) {
  const Self self = check_self(state, Kind::group, "bounds");
  const Things things = things_of(self.world, group_id(self));
  if (things.bodies.empty() && things.free_points.empty()) {
    lua_pushnil(state);
    lua_pushnil(state);
    return 2;
  }
  const Bounds box = bounds(self.world, things);
  push(state, box.low);
  push(state, box.high);
  return 2;
}

int clusters_of(lua_State* state) {
  const Self self = check_self(state, Kind::group, "clusters");
  const double distance = check_number(state, 2, "clusters", "argument 1, the distance,", "m");
  require(distance >= 0, "clusters: argument 1, the distance, must be >= 0 m, got ", distance);
  lua_newtable(state);
  lua_Integer i = 0;
  for (const std::vector<AnyId>& cluster : clusters(self.world, group_id(self), distance)) {
    push_list(state, self.script, cluster);
    lua_rawseti(state, -2, ++i);
  }
  return 1;
}

Type make_group_type() {
  Type type = type_with(fields::group_type());
  type.methods = {
      {"add", guard<add_things>, "thing: Thing, ...: Thing", "Group", "Adds things; returns the group.",
       "scene:group(\"a pair\"):add(p, q)"},
      {"remove", guard<remove_things>, "thing?: Thing, ...: Thing", "",
       "Takes things out of the set; without any, ends the set.", "group:remove(p)"},
      {"each", guard<each_member>, "", "fun(): Thing?",
       "For loops: for thing in g:each() do … end. Goes over a copy and leaves out what died.",
       "for thing in group:each() do thing.data.found = true end"},
      {"cut_hinges", guard<cut_hinges>, "", "",
       "Cuts the hinges in the group and those between its bodies, of the groups in it, too.",
       "scene:at(1, function() group:cut_hinges() end)"},
      {"break_connections", guard<group_break_connections>, "", "",
       "Removes the connections in the group and those among its things.",
       "scene:connect(p, q, spring)\n"
       "group:break_connections()"},
      {"heat", guard<group_heat>, "energy: number [J]", "",
       "Adds kinetic energy relative to the common motion; a negative one cools. What moves goes on faster or slower; "
       "what rests gets random velocities, of which the next step takes what ties forbid (in the ledger's `edit`): "
       "heat again for the rest.",
       "group:heat(5)"},
      {"move", guard<move_things>, "by: vec [m], turn?: quat", "Group",
       "Moves its bodies and particles as one, hinges and all; `turn` turns them about their centre of mass first, "
       "with their "
       "velocities. Returns the group.",
       "group:move(vec(0, 2, 0), quat(vec(0, 1, 0), math.pi))"},
      {"bounds", guard<bounds_of>, "", "vec?, vec?",
       "Lower and upper corner [m] of the box round all its points; nil where it has none.",
       "local lower, upper = group:bounds()"},
      {"clusters", guard<clusters_of>, "distance: number [m]", "Thing[][]",
       "Lists of what is within the distance of another member, biggest first.",
       "local biggest = group:clusters(2)[1]"},
  };
  add_base(type, any_set_type());
  type.length = guard<count_members>;
  return type;
}

}  // namespace

const Type& group_type() {
  static const Type type = make_group_type();
  return type;
}

}  // namespace pantin::lua
