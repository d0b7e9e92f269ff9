#include "lua/thing/turn_constraint_options.hpp"

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

}  // namespace

int scene_weld(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "weld");
  const BodyId a = check_body(state, 2, "weld", argument(1)), b = check_body(state, 3, "weld", argument(2));
  const Options o(state, 4, "weld", with_common({}));
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
  const Options o(state, options, "orient", with_common({"time_constant"}));
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
  const Options o(state, next + 1, "align", with_common({"angle", "time_constant"}));
  NumberOrFunction angle;
  if (o.has("angle")) {
    angle = check_number_of_time(self, o.push("angle"), "align", "angle", "rad");
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
  const Options o(state, next, "motor", with_common({"axis", "speed", "angle", "max_torque", "time_constant"}));
  MotorDef def;
  def.axis = axis_option(self, o);
  require(!o.has("speed") || !o.has("angle"), "motor: give its speed or its angle, not both");
  for (const char* name : {"speed", "angle"}) {
    if (!o.has(name)) continue;
    const bool of_speed = name[0] == 's';
    NumberOrFunction given = check_number_of_time(self, o.push(name), "motor", name, of_speed ? "rad/s" : "rad");
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
  const Options o(state, next, "limit",
                  with_common(of_angle ? std::vector<std::string>{"axis", "min", "max", "time_constant"}
                                       : std::vector<std::string>{"length", "min", "max", "time_constant"}));
  LimitDef def;
  const char* unit = of_angle ? "rad" : "m";
  if (!of_angle) def.max = o.number("length", unit).value_or(def.max);
  def.min = o.number_or_infinity("min", unit).value_or(def.min);
  def.max = o.number_or_infinity("max", unit).value_or(def.max);
  read_time_constant(o, def);
  if (!of_angle)
    return finish(
        self, place ? add_limit(self.world, point_a, *place, def) : add_limit(self.world, point_a, point_b, def), o);
  return finish(self, add_limit(self.world, body_a, body_b, axis_option(self, o), def), o);
}

}  // namespace pantin::lua
