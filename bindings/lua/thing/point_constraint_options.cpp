#include "lua/thing/point_constraint_options.hpp"

#include "edit/assemble.hpp"
#include "edit/constrain.hpp"
#include "edit/edit.hpp"
#include "lua/thing/constraint_options.hpp"
#include "lua/thing/constraint_values.hpp"
#include "lua/thing/fields.hpp"
#include "lua/thing/script.hpp"
#include "lua/thing/script_functions.hpp"
#include "lua/thing/targets.hpp"
#include "lua/value/arguments.hpp"
#include "lua/vm/guard.hpp"

namespace pantin::lua {
namespace {

/// A member of a hinge: a point, or a particle for its point.
PointId hinge_member(lua_State* state, int index) {
  const std::string name = argument(index - 1);
  const Ref* ref = to_ref(state, index);
  require(ref && (ref->kind == Kind::point || ref->kind == Kind::particle), "hinge: ", name,
          " must be a point or a free particle, got ", kind_of_value(state, index));
  return check_point(state, index, "hinge", name);
}

}  // namespace

std::function<Vec3(double)> position_of_time(Callback function, std::string what) {
  return CalledPosition{std::move(function), std::move(what)};
}

int scene_hinge(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "hinge");
  const int count = lua_gettop(state);
  const bool with_options = count > 1 && lua_istable(state, count);
  std::vector<PointId> points;
  for (int i = 2; i <= count - (with_options ? 1 : 0); i++) points.push_back(hinge_member(state, i));
  HingeDef def;
  const Options o(state, with_options ? count : count + 1, "hinge",
                  {"color", "radius", "lifetime", "name", "family", "axis", "collide", "breaks_at"});
  if (o.has("family")) {
    def.family = check_kind(state, o.push("family"), Kind::family, "hinge", "family").id<FamilyId>();
    lua_pop(state, 1);
  }
  def.color = o.color("color");
  def.radius = o.number("radius", "m");
  def.lifetime = o.number_or_infinity("lifetime", "s").value_or(def.lifetime);
  def.name = o.string("name").value_or("");
  def.axis = o.vector("axis", "");
  def.collide = o.boolean("collide").value_or(false);
  const ParticleId hinge = add_hinge(self.world, points, def);
  if (o.has("breaks_at")) {
    try {
      set_breaks_at(self.world, hinge,
                    check_breaking(state, o.push("breaks_at"), "hinge: breaks_at", {"force", "torque"}));
    } catch (...) {
      cut(self.world, hinge);
      throw;
    }
  }
  push_thing(state, self.script, hinge);
  return 1;
}

namespace {

int scene_nail(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "nail");
  const PointId point = check_point(state, 2, "nail", argument(1));
  std::optional<Vec3> at;
  int options = 3;
  if (!lua_istable(state, 3)) {
    options = 4;
    if (!lua_isnoneornil(state, 3)) at = check_vec(state, 3, "nail", "argument 2, the position,", "m");
  }
  const Options o = tie_options(state, options, "nail", {"time_constant"});
  const auto time_constant = o.number("time_constant", "s");
  return finish(self, time_constant ? add_nail(self.world, point, at, *time_constant) : add_nail(self.world, point, at),
                o);
}

int scene_follow(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "follow");
  const PointId point = check_point(state, 2, "follow", argument(1));
  FollowDef def;
  const Ref* ref = to_ref(state, 3);
  if (lua_isfunction(state, 3)) {
    def.target = position_of_time(Callback(state, 3), "follow: target");
  } else if (ref && ref->kind == Kind::hand) {
    def.hand = static_cast<std::int32_t>(ref->slot) - 1;
  } else {
    require(to_vec(state, 3).has_value(),
            "follow: argument 2, the target, must be a vec [m], a function of time or a hand, got ",
            kind_of_value(state, 3));
    def.at = check_vec(state, 3, "follow", "argument 2, the target,", "m");
  }
  const Options o = tie_options(state, 4, "follow", {"max_force", "time_constant"});
  def.max_force = o.number_or_infinity("max_force", "N").value_or(def.max_force);
  def.time_constant = o.number("time_constant", "s").value_or(def.time_constant);
  return finish(self, add_follow(self.world, point, def), o);
}

int scene_rod(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "rod");
  const bool place_first = to_vec(state, 2).has_value(), place_second = to_vec(state, 3).has_value();
  require(!(place_first && place_second), "rod: one end must be a point or a particle, got two vecs");
  const PointId a = check_point(state, place_first ? 3 : 2, "rod", argument(place_first ? 2 : 1));
  std::optional<double> length;
  NumberOrFunction given;
  const bool without_length = lua_istable(state, 4);
  const Options o = tie_options(state, without_length ? 4 : 5, "rod", {});
  if (!without_length && !lua_isnoneornil(state, 4)) {
    given = check_number_of_time(self, 4, "rod", "argument 3, the length,", "m", ConstraintKind::rod);
    length = given.value;
  }
  ConstraintId rod;
  if (place_first || place_second) {
    const int at = place_first ? 2 : 3;
    rod = add_rod(self.world, a, check_vec(state, at, "rod", argument(at - 1), "m"), length);
  } else {
    rod = add_rod(self.world, a, check_point(state, 3, "rod", argument(2)), length);
  }
  if (given.function) set_length(self.world, rod, given.value, std::move(given.function));
  return finish(self, rod, o);
}

int scene_join(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "join");
  const PointId a = check_point(state, 2, "join", argument(1)), b = check_point(state, 3, "join", argument(2));
  const Options o(state, 4, "join", {"at", "time_constant", "max_force", "on_met", "name", "axis"});
  JoinDef def;
  def.at = o.vector("at", "m");
  def.time_constant = o.number("time_constant", "s").value_or(def.time_constant);
  def.max_force = o.number_or_infinity("max_force", "N").value_or(def.max_force);
  def.name = o.string("name").value_or("");
  def.axis = o.vector("axis", "").value_or(zero3());
  if (const auto on_met = o.function("on_met")) def.on_met = CalledOnMet{*on_met, &self.script};
  push_thing(state, self.script, add_join(self.world, a, b, def));
  return 1;
}

}  // namespace

const ConstraintCall nail_call = {
    {"nail", guard<scene_nail>, "point: Point|Particle, at?: vec|TieOptions [m], options?: TieOptions", "Nail",
     "Keeps a point at a position, or where it is.",
     "scene:nail(arm.head)\n"
     "scene:nail(p, vec(0, 2, 0), { time_constant = 0.2 })"},
    "a point to a position or to something that moves",
    R"(---@class TieOptions: ConstraintOptions
---@field time_constant? number [s] with which what is far is drawn there, critically damped (default `0.1`)
)"};

const ConstraintCall follow_call = {
    {"follow", guard<scene_follow>,
     "point: Point|Particle, target: vec|Hand|fun(t: number): vec [m], options?: FollowOptions", "Follow",
     "Keeps a point to a target: a position [m], a function of time [s] or a hand.",
     "scene:follow(p, function(t) return vec(math.cos(t), math.sin(t), 0) end, { max_force = 100 })"},
    "a point to a position or to something that moves",
    R"(---@class FollowOptions: ConstraintOptions
---@field time_constant? number [s] with which what is far is drawn there, critically damped (default `0.05`)
---@field max_force? number [N] it never pulls harder, and is a spring and damper then: a weight hangs g time_constant^2 lower (default `math.huge`)
)"};

const ConstraintCall rod_call = {
    {"rod", guard<scene_rod>,
     "a: Point|Particle|vec [m], b: Point|Particle|vec [m], length?: number|fun(t: number): number|ConstraintOptions "
     "[m], options?: ConstraintOptions",
     "Rod", "Keeps two points, or a point and a position, at a distance, or at their present one.",
     "scene:rod(p, q, { name = \"strut\", breaks_at = { force = 200 } })\n"
     "scene:rod(p, vec(-2, 4, 0), function(t) return 3 + 0.1 * math.sin(t) end)"},
    "a distance: kept, in a range, or along a string"};

const ConstraintCall join_call = {
    {"join", guard<scene_join>, "a: Point|Particle, b: Point|Particle, options?: JoinOptions", "Join",
     "Draws two points together, at a position or on their way to each other, and makes the hinge when they are "
     "within "
     "a tenth of scene.tolerance of their size, some 20 time constants later. Without at, momentum is kept on the "
     "way, and so is angular momentum: they come together on a straight line, and what that takes goes into the "
     "turning of all that hangs on them. Two free particles alone have nothing to turn, and lose theirs. The two do "
     "not touch each other on the way.",
     "scene:join(p, q, { max_force = 50, on_met = function(hinge) print(hinge) end })"},
    "what is still apart",
    R"(---@class JoinOptions
---@field at? vec [m] where they meet (default on their way to each other)
---@field time_constant? number [s] with which they are drawn together (default `0.05`)
---@field max_force? number [N] it never pulls harder, until they are near (default `math.huge`)
---@field axis? vec [1] the hinge turns about it only; world axes as they are when it is made (default none: about any)
---@field on_met? fun(hinge: Particle) called in the step after (default none)
---@field name? string of the hinge (default `""`)
)"};

}  // namespace pantin::lua
