#include "constraints/coupling.hpp"

#include <algorithm>
#include <cmath>

#include "base/functions.hpp"
#include "constraints/geometry.hpp"
#include "constraints/row_rule.hpp"

namespace pantin {

namespace {

double value_of(const Model& model, const CoupledValue& v) {
  if (v.body_a) return v.angle;
  const Vec3 d = position(model, v.point_a) - (v.point_b ? position(model, v.point_b) : v.position);
  if (norm2(v.direction) > 0.0) return dot(v.direction, d);
  return v.side < 0.0 ? -norm(d) : norm(d);
}

/// How far it is turned now [rad], nearest to what was counted last: it may have turned while the coupling was off.
double present_angle(const Model& model, const CoupledValue& v) {
  constexpr double turn = 6.283185307179586;
  const Quat frame = v.body_b ? orientation(model, v.body_b) : Quat{};
  const Quat q = conjugate(frame) * orientation(model, v.body_a) * conjugate(v.turn);
  const double angle = 2.0 * functions::atan2(dot(vec(q.x, q.y, q.z), v.axis_b), q.w);
  return angle + turn * std::round((v.angle - angle) / turn);
}

/// On which side of its second point a distance is, along the axis of the first value.
double present_side(const Model& model, const CoupledValue& of_axis, const CoupledValue& v) {
  const Vec3 d = position(model, v.point_a) - position(model, v.point_b);
  return dot(direction_of(model, of_axis.body_b, of_axis.axis_b), d) < 0.0 ? -1.0 : 1.0;
}

double gyration(const Model& model, BodyId body) {
  const Motion& m = model.motion_of(body);
  return std::sqrt((m.inertia[0] + m.inertia[1] + m.inertia[2]) / (2.0 * m.mass));
}

}  // namespace

// Coupled rows are done together, once all rows are placed.
const RowRule coupled_row = {.evaluate = [](Row&, Condition&, const RowContext&) { return 0.0; }};

double weight_of(const Constraint& c, const CoupledValue& v) {
  return v.fixed + v.by_ratio * (0.5 * (c.number.previous + c.number.now));
}

double coupled_sum(const Model& model, const Constraint& c) {
  double sum = 0.0;
  for (const CoupledValue& v : c.coupled()) sum += weight_of(c, v) * value_of(model, v);
  return sum;
}

void start_coupling(const Model& model, Constraint& c, double) {
  CouplingData& data = c.as<CouplingData>();
  for (CoupledValue& v : data.values) {
    if (v.body_a) v.angle = present_angle(model, v);
    if (v.side != 0.0) v.side = present_side(model, data.values[0], v);
  }
  const double sum = coupled_sum(model, c);
  data.total = has_range(c) ? std::fmax(data.total, sum) : sum;  // a rope that is long enough stays as long
}

double coupling_gap(const Model& model, const Constraint& c) {
  double most = 0.0;  // by how much the sum changes with a motion of a metre of one of its things
  for (const CoupledValue& v : c.coupled()) {
    double lever = v.body_a ? gyration(model, v.body_a) : 1.0;
    if (v.body_a && v.body_b) lever = std::fmin(lever, gyration(model, v.body_b));
    most = std::fmax(most, std::fabs(weight_of(c, v)) / lever);
  }
  const double over = coupled_sum(model, c) - c.as<CouplingData>().total;
  return (has_range(c) ? std::fmax(0.0, over) : std::fabs(over)) / most;
}

std::vector<RowPlan> coupling_rows(const Model&, const Constraint& c) {
  std::vector<RowPlan> plans;
  for (std::uint32_t i = 0; i < c.coupled().size(); i++) {
    const CoupledValue& v = c.coupled()[i];
    plans.push_back({RowKind::coupled, static_cast<bool>(v.body_a), v.point_a, v.point_b, v.body_a, v.body_b, v.axis_a,
                     v.axis_b, i});
  }
  return plans;
}

std::vector<PlaneNeed> axes_of_coupling(const Model& model, const Constraint& c) {
  std::vector<PlaneNeed> needs;
  for (const CoupledValue& v : c.coupled())
    if (v.body_a) needs.push_back({"axis", direction_of(model, v.body_a, v.axis_a), true});
  return needs;
}

void follow_ratio(const Model& model, Constraint& c, double before) {
  const double change = 0.5 * (c.number.previous + c.number.now) - before;
  CouplingData& data = c.as<CouplingData>();
  for (const CoupledValue& v : data.values) data.total += v.by_ratio * change * value_of(model, v);
}

namespace {

/// Of a distance its side, and the axis by which that is told where its points meet.
void load_side(Condition& condition, const Model& model, const CoupledValue& of_axis, const CoupledValue& v) {
  condition.angle0 = condition.angle1 = v.side;
  if (v.side == 0.0) return;
  const Quat to_b = of_axis.body_b ? conjugate(model.bodies[of_axis.body_b].axes) : Quat{};
  condition.axis = model.plane.axis(rotate(to_b, of_axis.axis_b));
}

}  // namespace

void load_coupling(Condition& condition, const Row& row, const Model& model, const Constraint& c) {
  const CoupledValue& v = c.coupled()[condition.index];
  const double unit = row.lever > 0.0 ? 1.0 / row.lever : 1.0;
  condition.weight = weight_of(c, v) * unit;
  condition.weight0 = (v.fixed + v.by_ratio * c.number.previous) * unit;
  condition.weight1 = (v.fixed + v.by_ratio * c.number.now) * unit;
  condition.whole_length0 = condition.whole_length1 = c.as<CouplingData>().total;
  condition.length_rate = 0.0;
  condition.works = condition.ranged;
  condition.bent = Bent::nothing;
  condition.velocity = zero3();
  condition.whole0 = condition.whole1 = model.plane.along(v.position);
  condition.direction = model.plane.along(v.direction);
  if (!v.body_a) return load_side(condition, model, c.coupled()[0], v);
  const Quat to_b = v.body_b ? conjugate(model.bodies[v.body_b].axes) : Quat{};
  const Quat turn = to_b * (v.turn * model.bodies[v.body_a].axes);
  condition.whole0 = condition.whole1 = zero3();
  condition.whole_turn0 = condition.whole_turn1 = model.plane.about(turn);
  condition.axis = condition.axis0 = condition.axis1 = model.plane.axis(rotate(to_b, v.axis_b));
  condition.angle0 = condition.angle1 = v.angle;
  condition.extent = std::fabs(v.angle) * row.lever;
}

bool tells_load(const Condition& condition, const Row& row, const Constraint& c) {
  return c.coupled().empty() || condition.index == 0 || (row.lever == 0.0 && c.coupled()[0].body_a);
}

void store_coupling(const Condition& condition, const Row& row, Vec3 force, Constraint& c) {
  CoupledValue& v = c.as<CouplingData>().values[condition.index];
  (row.lever > 0.0 ? v.angle : v.side) = condition.angle1;
  if (!tells_load(condition, row, c)) return;
  if (row.lever > 0.0) {
    c.torque = force * row.lever;
    return;
  }
  c.tension = -dot(force, direction(row.d1));
  c.force = force;
}

}  // namespace pantin
