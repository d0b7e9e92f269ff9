#include "lua/thing/coupling_constraint_options.hpp"

#include "edit/coupling_constraints.hpp"
#include "lua/thing/constraint_options.hpp"
#include "lua/thing/targets.hpp"
#include "lua/value/arguments.hpp"
#include "lua/vm/guard.hpp"

namespace pantin::lua {
namespace {

/// The proportion of a coupling: a number or a function of time; throws Error where there is none.
Ratio check_ratio(const Self& self, const Options& o, const char* name, const char* unit) {
  require(o.has(name), o.what(), ": ", name, " must be given", *unit ? text(" [", unit, "]") : std::string(),
          ", a number or a function of time [s]");
  NumberOrFunction given = check_number_of_time(self, o.push(name), o.what().c_str(), name, unit);
  return {given.value, std::move(given.function)};
}

BodyId carrier_option(const Self& self, const Options& o) {
  return o.has("carrier") ? check_body(self.state, o.push("carrier"), o.what(), "carrier") : BodyId{};
}

}  // namespace

int scene_gear(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "gear");
  const BodyId a = check_body(state, 2, "gear", argument(1)), b = check_body(state, 3, "gear", argument(2));
  const Options o(state, 4, "gear", with_common({"ratio", "axis", "axis_b", "carrier"}));
  GearDef def;
  def.ratio = check_ratio(self, o, "ratio", "");
  def.axis_a = axis_option(self, o);
  def.axis_b = o.vector("axis_b", "");
  def.carrier = carrier_option(self, o);
  return finish(self, add_gear(self.world, a, b, def), o);
}

int scene_rack(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "rack");
  const BodyId wheel = check_body(state, 2, "rack", argument(1));
  const PointId point = check_point(state, 3, "rack", argument(2));
  const Options o(state, 4, "rack", with_common({"radius", "axis", "along", "carrier"}));
  RackDef def;
  def.radius = check_ratio(self, o, "radius", "m");
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
  const Options o(state, 6, "pulley", with_common({"ratio", "length", "time_constant"}));
  PulleyDef def;
  if (o.has("ratio")) def.ratio = check_ratio(self, o, "ratio", "");
  def.length = o.number("length", "m");
  read_time_constant(o, def);
  return finish(self, add_pulley(self.world, a, over_a, b, over_b, def), o);
}

int scene_screw(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "screw");
  const PointId a = check_point(state, 2, "screw", argument(1)), b = check_point(state, 3, "screw", argument(2));
  const Options o(state, 4, "screw", with_common({"lead", "axis"}));
  ScrewDef def;
  def.lead = check_ratio(self, o, "lead", "m");
  require(o.has("axis"), "screw: axis must be given, a vec in world axes");
  def.axis = *o.vector("axis", "");
  return finish(self, add_screw(self.world, a, b, def), o);
}

}  // namespace pantin::lua
