// scene:weld, orient, align, motor and limit.
#include "lua/thing/constraint_options.hpp"
#include "lua/thing/script.hpp"
#include "lua/thing/targets.hpp"
#include "lua/value/arguments.hpp"
#include "lua/vm/guard.hpp"

namespace pantin::lua {
namespace {

/// Where a second body may be left out for the world: that body, or null; moves `index` past it.
BodyId second_body(lua_State* state, int& index, const char* call) {
  if (const Ref* ref = to_ref(state, index); ref || lua_isnil(state, index)) {
    const int at = index++;
    return ref ? check_body(state, at, call, argument(at - 1)) : BodyId{};
  }
  return {};
}

int scene_weld(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "weld");
  const BodyId a = check_body(state, 2, "weld", argument(1)), b = check_body(state, 3, "weld", argument(2));
  const Options o = tie_options(state, 4, "weld", {});
  return finish(self, add_weld(self.world, a, b), o);
}

int scene_orient(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "orient");
  const BodyId body = check_body(state, 2, "orient", argument(1));
  OrientDef def;
  int options = 3;
  if (lua_isfunction(state, 3))
    def.target = quat_of_time(Callback(state, 3), "orient: target");
  else if (!lua_istable(state, 3) && !lua_isnoneornil(state, 3))
    def.to = check_quat(state, 3, "orient", "argument 2, a quat or a function of time,");
  if (!lua_istable(state, 3)) options = 4;
  const Options o = tie_options(state, options, "orient", {"time_constant"});
  read_time_constant(o, def);
  return finish(self, add_orient(self.world, body, def), o);
}

int scene_align(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "align");
  const BodyId a = check_body(state, 2, "align", argument(1));
  AlignDef def;
  def.axis_a = check_vec(state, 3, "align", "argument 2, the axis of the first body,", "");
  int next = 4;
  const BodyId b = second_body(state, next, "align");
  def.axis_b = check_vec(state, next, "align", argument(next - 1) + ", the second axis,", "");
  const Options o = tie_options(state, next + 1, "align", {"angle", "time_constant"});
  NumberOrFunction angle;
  if (o.has("angle")) {
    angle = check_number_of_time(self, o.push("angle"), "align", "angle", "rad", ConstraintKind::align);
    def.angle = angle.value;
  }
  read_time_constant(o, def);
  const ConstraintId align = add_align(self.world, a, b, def);
  if (angle.function) set_length(self.world, align, angle.value, std::move(angle.function));
  return finish(self, align, o);
}

int scene_motor(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "motor");
  const BodyId a = check_body(state, 2, "motor", argument(1));
  int next = 3;
  const BodyId b = second_body(state, next, "motor");
  const Options o = tie_options(state, next, "motor", {"axis", "speed", "angle", "max_torque", "time_constant"});
  MotorDef def;
  def.axis = axis_option(self, o);
  require(!o.has("speed") || !o.has("angle"), "motor: give its speed or its angle, not both");
  for (const char* name : {"speed", "angle"}) {
    if (!o.has(name)) continue;
    const bool of_speed = name[0] == 's';
    NumberOrFunction given =
        check_number_of_time(self, o.push(name), "motor", name, of_speed ? "rad/s" : "rad", ConstraintKind::motor);
    (of_speed ? def.speed : def.angle) = given.value;
    def.number = std::move(given.function);
  }
  def.max_torque = o.number_or_infinity("max_torque", "N m").value_or(def.max_torque);
  read_time_constant(o, def);
  return finish(self, add_motor(self.world, a, b, def), o);
}

int scene_limit(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "limit");
  const Ref* first = to_ref(state, 2);
  const bool of_angle = first && first->kind == Kind::body;
  BodyId body_a, body_b;
  PointId point_a, point_b;
  std::optional<Vec3> place;
  int next = 3;
  if (of_angle) {
    body_a = check_body(state, 2, "limit", argument(1));
    body_b = second_body(state, next, "limit");
  } else {
    point_a = check_point(state, 2, "limit", argument(1));
    if (to_vec(state, next))
      place = check_vec(state, next, "limit", argument(2), "m");
    else
      point_b = check_point(state, next, "limit", argument(2));
    next++;
  }
  const Options o = tie_options(state, next, "limit",
                                of_angle ? std::vector<std::string>{"axis", "min", "max", "time_constant"}
                                         : std::vector<std::string>{"length", "min", "max", "time_constant"});
  LimitDef def;
  const char* unit = of_angle ? "rad" : "m";
  require(!o.has("length") || !o.has("max"), "limit: give length or max, which are the same, not both");
  if (!of_angle) def.max = o.number("length", unit).value_or(def.max);
  def.min = o.number_or_infinity("min", unit).value_or(def.min);
  def.max = o.number_or_infinity("max", unit).value_or(def.max);
  read_time_constant(o, def);
  if (!of_angle)
    return finish(
        self, place ? add_limit(self.world, point_a, *place, def) : add_limit(self.world, point_a, point_b, def), o);
  return finish(self, add_limit(self.world, body_a, body_b, axis_option(self, o), def), o);
}

}  // namespace

const ConstraintCall weld_call = {
    {"weld", guard<scene_weld>, "a: Body, b: Body, options?: ConstraintOptions", "Weld",
     "Keeps two bodies in their present relative position and orientation; it tells its load, and may break. The two "
     "pass "
     "through each other, and touch everything else.",
     "local weld = scene:weld(arm, block, { breaks_at = { force = 500, torque = 100 } })"},
    "two bodies, or how a body is turned"};

const ConstraintCall orient_call = {
    {"orient", guard<scene_orient>, "body: Body, to?: quat|OrientOptions|fun(t: number): quat, options?: OrientOptions",
     "Orient", "Keeps the orientation of a body, or its present one.",
     "scene:orient(block, quat(vec(0, 0, 1), math.pi / 4), { time_constant = 0.5 })"},
    "two bodies, or how a body is turned",
    R"(---@class OrientOptions: ConstraintOptions
---@field time_constant? number [s] with which what is far is drawn there, critically damped (default `0.1`)
)"};

const ConstraintCall align_call = {
    {"align", guard<scene_align>,
     "a: Body, axis_a: vec [1], b?: Body|vec [1], axis_b?: vec|AlignOptions [1], options?: AlignOptions", "Align",
     "Keeps the angle between an axis of a and one of b, each in its body's frame; without b, one of the world.",
     "scene:align(arm, vec(1, 0, 0), block, vec(0, 1, 0))\n"
     "scene:align(block, vec(0, 1, 0), vec(0, 1, 0), { angle = 0 })"},
    "two bodies, or how a body is turned",
    R"(---@class AlignOptions: OrientOptions
---@field angle? number|fun(t: number): number [rad] of 0 to π (default the present one)
)"};

const ConstraintCall motor_call = {
    {"motor", guard<scene_motor>, "a: Body, b?: Body|MotorOptions, options?: MotorOptions", "Motor",
     "Turns a about an axis (world axes) against b, or without b against the world.",
     "scene:motor(arm, leg, { axis = vec(0, 0, 1), speed = 2, max_torque = 5 })\n"
     "scene:motor(block, { axis = vec(0, 1, 0), angle = function(t) return 0.5 * t end })"},
    "an angle or a speed by a motor",
    R"(---One of speed and angle must be given.
---@class MotorOptions: OrientOptions
---@field axis? vec [1] world axes; it stays fixed in a (default the normal of scene.plane; without one it must be given)
---@field speed? number|fun(t: number): number [rad/s] of a against b (default none)
---@field angle? number|fun(t: number): number [rad] of a against b, 0 where it is now (default none)
---@field max_torque? number [N m] it never pushes harder (default `math.huge`)
)",
    "MotorOptions"};

const ConstraintCall limit_call = {
    {"limit", guard<scene_limit>,
     "a: Body|Point|Particle, b?: Body|Point|Particle|vec|LimitOptions [m], options?: LimitOptions", "Limit",
     "Keeps the angle of a against b about an axis, 0 where it is now, or the distance of two points, in a range.",
     "scene:limit(arm, leg, { axis = vec(0, 0, 1), min = -0.5, max = 0.5 })\n"
     "scene:limit(p, q, { length = 3 })"},
    "a distance: kept, in a range, or along a string",
    R"(---@class LimitOptions: OrientOptions
---@field axis? vec [1] of an angle; world axes (default the normal of scene.plane; without one it must be given)
---@field min? number [rad or m] (default `-math.huge`; of a distance 0)
---@field max? number [rad or m] (default `math.huge`)
---@field length? number [m] of a distance, the same as max (default none)
)"};

}  // namespace pantin::lua
