#include "constraints/coupling.hpp"

#include <algorithm>
#include <cmath>

#include "base/functions.hpp"
#include "constraints/geometry.hpp"
#include "constraints/row_rule.hpp"

namespace pantin {

namespace {

/// Where the second end of a distance is.
Vec3 end_of(const Model& model, const CoupledValue& v) {
  if (v.point_b) return position(model, v.point_b);
  return v.body_b ? origin(model, v.body_b) + direction_of(model, v.body_b, v.position) : v.position;
}

/// Whether it cannot change: a distance in one body, since two were merged.
bool is_fixed(const Model& model, const CoupledValue& v) {
  if (!v.point_a || !v.point_b || v.body_b) return false;
  const BodyId body = model.points[v.point_a].body;
  return body && body == model.points[v.point_b].body;
}

}  // namespace

const RowRule coupled_row = {
    .coupled = true, .read_turn = count_angle, .evaluate = [](Row&, Condition&, const RowContext&) { return 0.0; }};

double value_of(const Model& model, const CoupledValue& v) {
  if (v.body_a) return v.angle;
  const Vec3 d = position(model, v.point_a) - end_of(model, v);
  return norm2(v.axis_b) > 0.0 ? dot(direction_of(model, v.body_b, v.axis_b), d) : norm(d);
}

double weight_of(const Constraint& c, const CoupledValue& v) {
  return v.fixed + v.by_ratio * (0.5 * (c.number.previous + c.number.now));
}

double coupled_sum(const Model& model, const Constraint& c) {
  double sum = 0.0;
  for (const CoupledValue& v : c.coupled()) sum += weight_of(c, v) * value_of(model, v);
  return sum;
}

namespace {

/// How fast its distances, which count as they are, make the sum larger [m/s].
double rate_of(const Model& model, const Constraint& c) {
  double sum = 0.0;
  for (const CoupledValue& v : c.coupled()) {
    const Vec3 along = direction(position(model, v.point_a) - end_of(model, v));
    const Vec3 apart = velocity(model, v.point_a) - (v.point_b ? velocity(model, v.point_b) : zero3());
    sum += weight_of(c, v) * dot(along, apart);
  }
  return sum;
}

}  // namespace

void start_coupling(const Model& model, Constraint& c, double tolerance) {
  CouplingData& data = c.as<CouplingData>();
  for (CoupledValue& v : data.values)
    if (v.body_a) v.angle = present_angle(model, v.body_a, v.body_b, v.turn, v.axis_b, v.angle);
  const double sum = coupled_sum(model, c);
  if (!has_range(c) || data.total == 0.0) data.total = sum;
  if (has_range(c)) start_number(c, std::fmax(0.0, sum - data.total), rate_of(model, c), tolerance * data.total);
}

double coupling_gap(const Model& model, const Constraint& c) {
  double most = 0.0;  // by how much the sum changes with a motion of a metre of one of its things
  for (const CoupledValue& v : c.coupled()) {
    const double length = v.body_a ? lever(model, v.body_a, v.body_b) : 1.0;
    most = std::fmax(most, std::fabs(weight_of(c, v)) / length);
  }
  const double over = coupled_sum(model, c) - c.as<CouplingData>().total - c.attract.excess;
  return (has_range(c) ? std::fmax(0.0, over) : std::fabs(over)) / most;
}

void add_coupled_rows(std::vector<RowPlan>& plans, const CoupledValue& v, std::uint32_t index) {
  if (v.body_a) {
    plans.push_back({&coupled_row, true, {}, {}, v.body_a, v.body_b, v.axis_a, v.axis_b, index});
    return;
  }
  const BodyId second = v.point_b ? BodyId{} : v.body_b;
  plans.push_back({&coupled_row, false, v.point_a, v.point_b, {}, second, zero3(), v.position, index});
  if (v.body_b) plans.push_back({&coupled_row, true, {}, {}, v.body_b, {}, v.axis_b, zero3(), index});
}

std::vector<RowPlan> coupling_rows(const Model& model, const Constraint& c) {
  std::vector<RowPlan> plans;
  for (std::uint32_t i = 0; i < c.coupled().size(); i++)
    if (!is_fixed(model, c.coupled()[i])) add_coupled_rows(plans, c.coupled()[i], i);
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

void load_coupling(Condition& condition, const Row& row, const Model& model, const Constraint& c) {
  const CoupledValue& v = c.coupled()[condition.index];
  const double unit = v.body_a ? 1.0 / row.lever : 1.0;
  condition.weight = weight_of(c, v) * unit;
  condition.weight0 = (v.fixed + v.by_ratio * c.number.previous) * unit;
  condition.weight1 = (v.fixed + v.by_ratio * c.number.now) * unit;
  condition.whole_value0 = c.as<CouplingData>().total + c.attract.previous_excess;
  condition.whole_value1 = c.as<CouplingData>().total + c.attract.excess;
  for (const CoupledValue& one : c.coupled())
    if (is_fixed(model, one)) {
      condition.whole_value0 -= (one.fixed + one.by_ratio * c.number.previous) * value_of(model, one);
      condition.whole_value1 -= (one.fixed + one.by_ratio * c.number.now) * value_of(model, one);
    }
  condition.value_rate = c.attract.excess_rate;
  condition.works_along_d = condition.ranged || condition.whole_value0 != condition.whole_value1;
  condition.bent = Bent::nothing;
  condition.driven = condition.driven && c.as<CouplingData>().apart;  // a ratio that changes gives nothing
  condition.velocity = zero3();
  condition.whole0 = condition.whole1 = row.lever > 0.0 || v.body_b ? zero3() : model.plane.along(v.position);
  const Quat to_b = v.body_b ? conjugate(model.bodies[v.body_b].axes) : Quat{};
  if (!v.body_a) {
    condition.axis = model.plane.along(rotate(to_b, v.axis_b));
    return;
  }
  const Quat turn = to_b * (v.turn * model.bodies[v.body_a].axes);
  condition.whole_turn0 = condition.whole_turn1 = model.plane.about(turn);
  condition.axis = condition.axis0 = condition.axis1 = model.plane.axis(rotate(to_b, v.axis_b));
  condition.angle0 = condition.angle1 = v.angle;
  condition.extent = std::fabs(v.angle) * row.lever;
}

bool tells_force(const Model& model, const Condition& condition, const Row& row, const Constraint& c) {
  if (c.coupled().empty()) return true;
  if (c.as<CouplingData>().apart) return !is_coupled(row);
  const CoupledValue& first = c.coupled()[0];
  const bool has_none = first.body_a || is_fixed(model, first);
  return !condition.turns_axis && (condition.index == 0 || (row.lever == 0.0 && has_none));
}

void store_coupling(const Condition& condition, const Row& row, const Model& model, Vec3 force, Constraint& c) {
  CoupledValue& v = c.as<CouplingData>().values[condition.index];
  if (v.body_a) v.angle = condition.angle1;
  if (c.as<CouplingData>().apart) {
    if (condition.turns_axis) return;
    v.force = force;
    c.force = zero3();
    for (const CoupledValue& one : c.coupled()) c.force += one.force;
    return;
  }
  if (!tells_force(model, condition, row, c)) return;
  if (row.lever > 0.0) {
    c.torque = force * row.lever;
    return;
  }
  const CoupledValue& first = c.coupled()[0];
  const double of_first = first.body_a ? 1.0 : weight_of(c, first) / weight_of(c, v);
  c.tension = std::fmax(0.0, -dot(force, direction(row.d0 + row.d1))) * of_first;
  c.force = force;
}

}  // namespace pantin
