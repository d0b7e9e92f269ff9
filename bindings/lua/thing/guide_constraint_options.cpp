// scene:string and on_path.
#include "edit/constrain.hpp"
#include "lua/thing/constraint_options.hpp"
#include "lua/thing/script.hpp"
#include "lua/thing/targets.hpp"
#include "lua/vm/guard.hpp"
#include "model/path.hpp"

namespace pantin::lua {
namespace {

int scene_string(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "string");
  require(lua_istable(state, 2), "string: argument 1 must be a list of points, particles or positions, got ",
          kind_of_value(state, 2));
  std::vector<Passage> passages;
  for (lua_Integer i = 1; lua_rawgeti(state, 2, i) != LUA_TNIL; i++) {
    passages.push_back(check_point_or_position(state, lua_gettop(state), "string", text("item ", i, " of the list")));
    lua_pop(state, 1);
  }
  lua_pop(state, 1);
  const Options o = tie_options(state, 3, "string", {"length", "time_constant"});
  StringDef def;
  NumberOrFunction length;
  if (o.has("length")) {
    length = check_number_of_time(self, o.push("length"), "string", "length", "m", ConstraintKind::string);
    def.length = length.value;
  }
  read_time_constant(o, def);
  const ConstraintId string = add_string(self.world, std::move(passages), def);
  if (length.function) set_length(self.world, string, length.value, std::move(length.function));
  return finish(self, string, o);
}

int scene_on_path(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "on_path");
  const PointId point = check_point(state, 2, "on_path", argument(1));
  require(lua_istable(state, 3), "on_path: argument 2, the path, must be a list of vecs [m], got ",
          kind_of_value(state, 3));
  std::vector<Vec3> places;
  for (lua_Integer i = 1; lua_rawgeti(state, 3, i) != LUA_TNIL; i++) {
    places.push_back(check_vec(state, lua_gettop(state), "on_path", text("position ", i, " of the path"), "m"));
    lua_pop(state, 1);
  }
  lua_pop(state, 1);
  const Options o = tie_options(state, 4, "on_path", {"smooth", "closed", "time_constant"});
  auto path = std::make_shared<const Path>(std::move(places), o.boolean("smooth").value_or(false),
                                           o.boolean("closed").value_or(false));
  const double time_constant = o.number("time_constant", "s").value_or(usual_time_constant);
  return finish(self, add_on_path(self.world, point, std::move(path), time_constant), o);
}

}  // namespace

const ConstraintCall string_call = {
    {"string", guard<scene_string>, "points: (Point|Particle|vec)[] [m], options?: StringOptions", "String",
     "Is at most so long along its points and positions, slides through the inner ones, and may go slack.",
     "local string = scene:string({ p, vec(0, 4, 0), q })\n"
     "string.length = 0.9 * string.length"},
    "a distance: kept, in a range, or along a string",
    R"(---@class StringOptions: OrientOptions
---@field length? number|fun(t: number): number [m] the most that it is long (default the present one)
)"};

const ConstraintCall on_path_call = {
    {"on_path", guard<scene_on_path>, "point: Point|Particle, path: vec[] [m], options?: PathOptions", "OnPath",
     "Keeps a point on a path through positions; at the end of an open one it stops.",
     "scene:on_path(p, { p.position, vec(0, 3, 0), vec(2, 3, 0) }, { smooth = true })"},
    "a point to a plane or to a path",
    R"(---@class PathOptions: OrientOptions
---@field smooth? boolean a spline with continuous curvature; else straight pieces, round whose corners a bead keeps its speed (default `false`)
---@field closed? boolean its end is its beginning (default `false`)
)"};

}  // namespace pantin::lua
