#include "edit/coupling_constraints.hpp"

#include <cmath>
#include <utility>

#include "constraints/coupling.hpp"
#include "edit/common.hpp"

namespace pantin {

using namespace internal;

namespace {

constexpr double pi = 3.14159265358979323846;

/// The angle of a body against a carrier, 0 now.
CoupledValue angle_of(const World& world, const char* call, BodyId body, BodyId carrier, Vec3 axis) {
  require_turning(world, call, body);
  if (carrier) require_turning(world, call, carrier);
  require(body != carrier, call, ": ", describe(world, body), " cannot turn against itself");
  CoupledValue v;
  v.body_a = body;
  v.body_b = carrier;
  v.axis_a = in_frame(world, body, axis);
  v.axis_b = in_frame(world, carrier, axis);
  v.turn = orientation(world, body);
  if (carrier) v.turn = normalised(conjugate(orientation(world, carrier)) * v.turn);
  return v;
}

ConstraintId add_coupling(World& world, ConstraintKind kind, std::vector<CoupledValue> values, const Ratio& ratio,
                          std::optional<double> length = {}, double time_constant = usual_time_constant) {
  Constraint c;
  c.kind = kind;
  c.number.now = ratio.value;
  c.number.of_time = ratio.function;
  for (const CoupledValue& v : values)
    if (!c.body_a && v.body_a) c.body_a = v.body_a;
  if (!values[0].body_a) c.a = values[0].point_a;
  c.own = CouplingData{std::move(values)};
  c.as<CouplingData>().total = length.value_or(0.0);
  c.as<CouplingData>().given = length.has_value();
  c.time_constant = time_constant;
  return add_constraint(world, std::move(c));
}

CoupledValue distance(const World& world, const char* call, PointId point, const Passage& to) {
  require_point(world, call, point);
  if (to.point) require_point(world, call, to.point);
  if (!to.point) require_finite(call, "an anchor", to.position, "m");
  const BodyId body = world.points[point].body;
  require(!to.point || to.point != point, call, ": ", describe(world, world.points[point].particle),
          " is its own anchor");
  require(!to.point || !body || body != world.points[to.point].body, call, ": both points belong to ",
          describe(world, body), ", which is rigid");
  CoupledValue v;
  v.point_a = point;
  v.point_b = to.point;
  v.position = to.position;
  return v;
}

/// Has a distance count along an axis of a body, or of the world.
void count_along(const World& world, CoupledValue& v, BodyId body, Vec3 axis) {
  v.body_b = body;
  v.axis_b = in_frame(world, body, axis);
  if (body && !v.point_b) v.position = in_frame(world, body, v.position - origin(world, body));
}

}  // namespace

ConstraintId add_gear(World& world, BodyId a, BodyId b, const GearDef& def) {
  const Vec3 axis_a = unit_vector("gear", "axis", def.axis_a),
             axis_b = def.axis_b ? unit_vector("gear", "the second axis", *def.axis_b) : axis_a;
  require(a != b, "gear: both are ", describe(world, a), "; it needs two bodies");
  std::vector<CoupledValue> values = {angle_of(world, "gear", a, def.carrier, axis_a),
                                      angle_of(world, "gear", b, def.carrier, axis_b)};
  values[1].fixed = 0.0;
  values[1].by_ratio = -1.0;
  return add_coupling(world, ConstraintKind::gear, std::move(values), def.ratio);
}

ConstraintId add_rack(World& world, BodyId wheel, PointId rack, const RackDef& def) {
  const Vec3 axis = unit_vector("rack", "axis", def.axis), along = unit_vector("rack", "along", def.along);
  require_point(world, "rack", rack);
  require(world.points[rack].body != wheel, "rack: its point belongs to the wheel, ", describe(world, wheel));
  require(!def.carrier || world.points[rack].body != def.carrier, "rack: its point belongs to the carrier, ",
          describe(world, def.carrier));
  std::vector<CoupledValue> values = {angle_of(world, "rack", wheel, def.carrier, axis),
                                      distance(world, "rack", rack, {{}, position(world, rack)})};
  values[0].fixed = 0.0;
  values[0].by_ratio = -1.0;
  count_along(world, values[1], def.carrier, along);
  return add_coupling(world, ConstraintKind::rack, std::move(values), def.radius);
}

ConstraintId add_pulley(World& world, PointId a, const Passage& over_a, PointId b, const Passage& over_b,
                        const PulleyDef& def) {
  if (def.length) require_positive("pulley", "length", *def.length, "m");
  std::vector<CoupledValue> values = {distance(world, "pulley", a, over_a), distance(world, "pulley", b, over_b)};
  values[1].fixed = 0.0;
  values[1].by_ratio = 1.0;
  return add_coupling(world, ConstraintKind::pulley, std::move(values), def.ratio, def.length, def.time_constant);
}

void set_rope_length(World& world, ConstraintId id, double length) {
  Constraint& c = of_kinds(world, id, {ConstraintKind::pulley}, "a rope's length");
  require_positive(describe(world, id), "length", length, "m");
  c.as<CouplingData>().total = length;
  start_constraint(world, c);
}

ConstraintId add_screw(World& world, PointId a, PointId b, const ScrewDef& def) {
  const Vec3 axis = unit_vector("screw", "axis", def.axis);
  for (PointId p : {a, b}) require_point(world, "screw", p);
  const BodyId first = world.points[a].body, second = world.points[b].body;
  require(first && second, "screw: both of its points must be of bodies");
  std::vector<CoupledValue> values = {angle_of(world, "screw", first, second, axis),
                                      distance(world, "screw", a, {b, zero3()})};
  values[0].fixed = 0.0;
  values[0].by_ratio = -1.0 / (2.0 * pi);
  count_along(world, values[1], second, axis);
  return add_coupling(world, ConstraintKind::screw, std::move(values), def.lead);
}

namespace {

/// Two directions across one, along world axes where that is.
std::pair<Vec3, Vec3> ways_across(Vec3 axis) {
  int least = 2;
  for (const int k : {1, 0})
    if (std::fabs(axis[k]) < std::fabs(axis[least])) least = k;
  Vec3 other = zero3();
  other[least] = 1.0;
  other = direction(other - axis * axis[least]);
  return {cross(other, axis), other};
}

}  // namespace

ConstraintId add_slider(World& world, PointId point, const SliderDef& def) {
  const Vec3 axis = unit_vector("slider", "axis", def.axis);
  require(!def.length || (std::isinf(def.min) && std::isinf(def.max)),
          "slider: it either keeps a length or has ends, min and max");
  CoupledValue value = distance(world, "slider", point, {{}, position(world, point)});
  const auto [first, second] = ways_across(axis);
  Constraint c;
  c.kind = ConstraintKind::slider;
  CouplingData data;
  data.apart = true;
  data.given = def.length.has_value();
  for (const Vec3 way : {first, second, axis, axis, -axis}) {
    data.values.push_back(value);
    count_along(world, data.values.back(), def.carrier, way);
  }
  c.own = std::move(data);
  c.a = point;
  if (const BodyId body = world.points[point].body; body && !def.turns) {
    require_turning(world, "slider", body);
    if (def.carrier) require_turning(world, "slider", def.carrier);
    c.body_a = body;
    c.body_b = def.carrier;
  }
  c.number.now = def.length.value_or(0.0);
  c.number.of_time = def.function;
  c.low = def.min;
  c.high = def.max;
  c.time_constant = def.time_constant;
  return add_constraint(world, std::move(c));
}

void set_ends(World& world, ConstraintId id, double min, double max) {
  Constraint& c = of_kinds(world, id, {ConstraintKind::slider}, "ends");
  require(!c.as<CouplingData>().given, describe(world, id), ": it keeps a length, and has no ends");
  require(min < max, describe(world, id), ": min must be below max, got ", min, " and ", max, " m");
  c.low = min;
  c.high = max;
  mark_edited(world, c);
  start_constraint(world, c);
}

}  // namespace pantin
