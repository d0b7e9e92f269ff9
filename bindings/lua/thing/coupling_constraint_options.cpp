// scene:gear, rack, pulley, screw and slider.
#include "edit/coupling_constraints.hpp"
#include "lua/thing/constraint_options.hpp"
#include "lua/thing/targets.hpp"
#include "lua/value/arguments.hpp"
#include "lua/vm/guard.hpp"

namespace pantin::lua {
namespace {

/// The proportion of a coupling: a number or a function of time; throws Error where there is none.
Ratio check_ratio(const Self& self, const Options& o, const char* name, const char* unit, ConstraintKind of) {
  require(o.has(name), o.what(), ": ", name, " must be given", *unit ? text(" [", unit, "]") : std::string(),
          ", a number or a function of time [s]");
  NumberOrFunction given = check_number_of_time(self, o.push(name), o.what().c_str(), name, unit, of);
  return {given.value, std::move(given.function)};
}

BodyId carrier_option(const Self& self, const Options& o) {
  return o.has("carrier") ? check_body(self.state, o.push("carrier"), o.what(), "carrier") : BodyId{};
}

int scene_gear(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "gear");
  const BodyId a = check_body(state, 2, "gear", argument(1)), b = check_body(state, 3, "gear", argument(2));
  const Options o = tie_options(state, 4, "gear", {"ratio", "axis", "axis_b", "carrier"});
  GearDef def;
  def.ratio = check_ratio(self, o, "ratio", "", ConstraintKind::gear);
  def.axis_a = axis_option(self, o);
  def.axis_b = o.vector("axis_b", "");
  def.carrier = carrier_option(self, o);
  return finish(self, add_gear(self.world, a, b, def), o);
}

int scene_rack(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "rack");
  const BodyId wheel = check_body(state, 2, "rack", argument(1));
  const PointId point = check_point(state, 3, "rack", argument(2));
  const Options o = tie_options(state, 4, "rack", {"radius", "axis", "along", "carrier"});
  RackDef def;
  def.radius = check_ratio(self, o, "radius", "m", ConstraintKind::rack);
  def.axis = axis_option(self, o);
  require(o.has("along"), "rack: along must be given, a vec in world axes");
  def.along = *o.vector("along", "");
  def.carrier = carrier_option(self, o);
  return finish(self, add_rack(self.world, wheel, point, def), o);
}

int scene_pulley(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "pulley");
  const PointId a = check_point(state, 2, "pulley", argument(1));
  const Passage over_a = check_point_or_position(state, 3, "pulley", argument(2)),
                over_b = check_point_or_position(state, 4, "pulley", argument(3));
  const PointId b = check_point(state, 5, "pulley", argument(4));
  const Options o = tie_options(state, 6, "pulley", {"ratio", "length", "time_constant"});
  PulleyDef def;
  if (o.has("ratio")) def.ratio = check_ratio(self, o, "ratio", "", ConstraintKind::pulley);
  def.length = o.number("length", "m");
  read_time_constant(o, def);
  return finish(self, add_pulley(self.world, a, over_a, b, over_b, def), o);
}

int scene_screw(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "screw");
  const PointId a = check_point(state, 2, "screw", argument(1)), b = check_point(state, 3, "screw", argument(2));
  const Options o = tie_options(state, 4, "screw", {"lead", "axis"});
  ScrewDef def;
  def.lead = check_ratio(self, o, "lead", "m", ConstraintKind::screw);
  require(o.has("axis"), "screw: axis must be given, a vec in world axes");
  def.axis = *o.vector("axis", "");
  return finish(self, add_screw(self.world, a, b, def), o);
}

int scene_slider(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "slider");
  const PointId point = check_point(state, 2, "slider", argument(1));
  const bool has_carrier = !lua_istable(state, 3);
  SliderDef def;
  if (has_carrier && !lua_isnoneornil(state, 3)) def.carrier = check_body(state, 3, "slider", argument(2));
  const Options o =
      tie_options(state, has_carrier ? 4 : 3, "slider", {"axis", "turns", "length", "min", "max", "time_constant"});
  require(o.has("axis"), "slider: axis must be given, a vec in world axes");
  def.axis = *o.vector("axis", "");
  def.turns = o.boolean("turns").value_or(false);
  if (o.has("length")) {
    NumberOrFunction given =
        check_number_of_time(self, o.push("length"), "slider", "length", "m", ConstraintKind::slider);
    def.length = given.value;
    def.function = std::move(given.function);
  }
  def.min = o.number_or_infinity("min", "m").value_or(def.min);
  def.max = o.number_or_infinity("max", "m").value_or(def.max);
  read_time_constant(o, def);
  return finish(self, add_slider(self.world, point, def), o);
}

}  // namespace

const ConstraintCall gear_call = {
    {"gear", guard<scene_gear>, "a: Body, b: Body, options: GearOptions", "Gear",
     "Turns a `ratio` times as far as b, each about an axis of a carrier or of the world. It keeps neither on its "
     "axis: "
     "hinges with an axis do.",
     "local gear = scene:gear(arm, block, { ratio = -2, axis = vec(0, 0, 1) })\n"
     "gear.ratio = -3"},
    "gears, racks, pulleys and screws",
    R"(---@class GearOptions: ConstraintOptions
---@field ratio number|fun(t: number): number [1] turns of a for one of b, in the sense of their axes; not 0, below 0 they turn against each other, as wheels do that mesh from outside
---@field axis? vec [1] of a, world axes; it stays fixed in a (default the normal of scene.plane; without one it must be given)
---@field axis_b? vec [1] of b (default `axis`)
---@field carrier? Body against which both turn, as the arm of a planetary gear (default the world)
)"};

const ConstraintCall rack_call = {
    {"rack", guard<scene_rack>, "wheel: Body, point: Point|Particle, options: RackOptions", "Rack",
     "Moves a point along a direction as far as the rim of a wheel turns.",
     "scene:rack(block, p, { radius = 0.5, axis = vec(0, 0, 1), along = vec(1, 0, 0) })"},
    "gears, racks, pulleys and screws",
    R"(---@class RackOptions: ConstraintOptions
---@field radius number|fun(t: number): number [m] how far the point moves for a turn of 1 rad; not 0
---@field axis? vec [1] of the wheel, world axes (default the normal of scene.plane; without one it must be given)
---@field along vec [1] in which the point moves when the wheel turns about the axis, world axes; it stays fixed in the carrier
---@field carrier? Body against which the wheel turns and the point moves (default the world)
)"};

const ConstraintCall pulley_call = {
    {"pulley", guard<scene_pulley>,
     "a: Point|Particle, over_a: Point|Particle|vec [m], over_b: Point|Particle|vec [m], b: Point|Particle, "
     "options?: "
     "PulleyOptions",
     "Pulley", "A rope from a over two anchors to b, at most so long; as in a tackle b's side may count several times.",
     "scene:pulley(p, vec(0, 5, 0), vec(1, 5, 0), q, { ratio = 2 })"},
    "gears, racks, pulleys and screws",
    R"(---@class PulleyOptions: OrientOptions
---@field ratio? number|fun(t: number): number [1] how many times b's side counts, > 0 (default `1`)
---@field length? number [m] the most that a's side and ratio times b's add up to (default the present one)
)"};

const ConstraintCall screw_call = {{"screw", guard<scene_screw>, "a: Point, b: Point, options: ScrewOptions", "Screw",
                                    "Moves a along an axis of b's body by `lead` for each turn of a's body about it.",
                                    "scene:screw(block.points[1], arm.head, { lead = 0.01, axis = vec(0, 1, 0) })"},
                                   "gears, racks, pulleys and screws",
                                   R"(---@class ScrewOptions: ConstraintOptions
---@field lead number|fun(t: number): number [m] by which the first point goes along the axis for a turn of its body about it; not 0
---@field axis vec [1] world axes; it stays fixed in both bodies
)"};

const ConstraintCall slider_call = {
    {"slider", guard<scene_slider>, "point: Point|Particle, carrier?: Body|SliderOptions, options?: SliderOptions",
     "Slider",
     "Keeps a point on the line through it along an axis, which goes with a body or, without one, stays in the world. "
     "The point's own body does not turn against that, unless it `turns`. The two do not touch.",
     "local slider = scene:slider(block.points[1], arm, { axis = vec(1, 0, 0), min = 0, max = 0.5 })\n"
     "scene:slider(p, { axis = vec(0, 1, 0), length = function(t) return 0.1 * math.sin(t) end })"},
    "a point to a plane or to a path",
    R"(---@class SliderOptions: OrientOptions
---@field axis vec [1] world axes; it stays fixed in the carrier
---@field turns? boolean the point's body turns freely about it, as a pin in a slot (default `false`)
---@field length? number|fun(t: number): number [m] how far along the axis it is kept, 0 where it is now (default none: it slides)
---@field min? number [m] least way along the axis, 0 where it is now; not with a length (default `-math.huge`)
---@field max? number [m] greatest way along the axis; not with a length (default `math.huge`)
)"};

}  // namespace pantin::lua
