#include "constraints/load.hpp"

#include "constraints/coupling.hpp"
#include "constraints/kind.hpp"
#include "constraints/row_rule.hpp"
#include "model/path.hpp"

namespace pantin {

namespace {

/// Frames of the bodies to principal axes: `turn` of a constraint as one between the nodes.
Quat between_nodes(const Model& model, const Constraint& c, const Quat& turn) {
  const Quat of_a = turn * model.bodies[c.body_a].axes;
  return c.body_b ? conjugate(model.bodies[c.body_b].axes) * of_a : of_a;
}

void load_angular_row(Condition& condition, const Row& row, const Model& model, const Constraint& c) {
  const Quat to_b = c.body_b ? conjugate(model.bodies[c.body_b].axes) : Quat{};
  condition.whole_turn0 = model.plane.about(between_nodes(model, c, c.turn.previous));
  condition.whole_turn1 = model.plane.about(between_nodes(model, c, c.turn.now));
  condition.axis = condition.axis0 = condition.axis1 = model.plane.axis(rotate(to_b, c.axis_b));
  condition.angle0 = condition.angle1 = c.angle;
  condition.whole_value0 = row.lever * (c.number.previous + c.attract.previous_excess);
  condition.whole_value1 = row.lever * (c.number.now + c.attract.excess);
  condition.value_rate = row.lever * (c.number.rate + c.attract.excess_rate);
  condition.low = row.lever * c.low;
  condition.high = row.lever * c.high;
  condition.upper = condition.jam_force > 0.0 ? 0.0 : std::fmin(c.max_torque / row.lever, condition.bound_in_touch);
  const double given = norm(row.f), driven_back = std::fmin(1.001 * condition.stall_force, condition.upper);
  if (given < 0.5 * condition.stall_force || given > driven_back) condition.stall_force = infinity;
  condition.lower = -condition.upper;
  condition.velocity = zero3();
  condition.whole0 = condition.whole1 = zero3();
  condition.by_speed = c.by_speed;
  condition.start_rate = row.lever * c.number.previous_rate;
  condition.bent = c.bend.straight() ? Bent::nothing : c.turn.of_time ? Bent::turn : Bent::value;
  condition.bend =
      c.bend.mapped(row.lever, [&](Vec3 v) { return c.turn.of_time ? model.plane.about(v) : v * row.lever; });
  condition.works_along_d = false;
  if (rule_of(c).load != nullptr) rule_of(c).load(condition, row, model, c);
  condition.works_along_d =
      condition.works_along_d || condition.ranged || condition.whole_value0 != condition.whole_value1 ||
      !same(condition.whole_turn0, condition.whole_turn1) || !same(condition.whole0, condition.whole1);
}

bool stays(double a, double b) { return a == b; }
bool stays(Vec3 a, Vec3 b) { return same(a, b); }
bool stays(const Quat& a, const Quat& b) { return same(a, b); }
bool is_zero(double rate) { return rate == 0.0; }
bool is_zero(Vec3 rate) { return norm2(rate) == 0.0; }

template <class Prescribed>
bool moves(const Prescribed& p) {
  return !is_zero(p.rate) || !is_zero(p.previous_rate) || !is_zero(p.change) || !stays(p.now, p.previous);
}

}  // namespace

void load(Condition& condition, const Row& row, const Model& model, double total_mass) {
  const Constraint& c = model.constraints[condition.constraint];
  condition.ranged = has_range(c) && !is_drawn_in(c);
  condition.held_before = condition.held;
  condition.driven = c.moves > 0 && (moves(c.position) || moves(c.number) || moves(c.turn));
  if (is_coupled(row) && c.is<CouplingData>()) {
    load_coupling(condition, row, model, c);
    if (rule_of(c).load != nullptr) rule_of(c).load(condition, row, model, c);
    return;
  }
  if (row.lever > 0.0) return load_angular_row(condition, row, model, c);
  condition.whole0 = model.plane.along(c.position.previous + c.attract.previous_away);
  condition.whole1 = model.plane.along(c.position.now + c.attract.away);
  condition.velocity = model.plane.along(c.position.rate + c.attract.away_rate);
  condition.whole_value0 = c.number.previous + c.attract.previous_excess;
  condition.whole_value1 = c.number.now + c.attract.excess;
  condition.value_rate = c.number.rate + c.attract.excess_rate;
  condition.bent = c.bend.straight() ? Bent::nothing : c.position.of_time ? Bent::position : Bent::value;
  condition.bend = c.bend.mapped(1.0, [&](Vec3 v) { return c.position.of_time ? model.plane.along(v) : v; });
  condition.low = c.low;
  condition.high = c.high;
  condition.normal = model.plane.axis(c.axis_a);
  if (rule_of(c).load != nullptr) rule_of(c).load(condition, row, model, c);
  condition.works_along_d = is_soft(row) || condition.ranged || condition.whole_value1 != condition.whole_value0;
  condition.max_force = c.max_force;
  condition.stiffness = total_mass / (c.time_constant * c.time_constant);  // critically damped for all that hangs at it
  condition.damping = 2.0 * total_mass / c.time_constant;
}

void store(const Condition& condition, const Row& row, const Model& model, Vec3 force, Constraint& c) {
  if (is_coupled(row) && c.is<CouplingData>()) return store_coupling(condition, row, model, force, c);
  if (row.lever > 0.0) {
    c.torque = force * row.lever;
    c.angle = condition.angle1;
    return;
  }
  if (c.is<PathData>()) {
    c.as<PathData>().along = condition.angle1;
    c.as<PathData>().run = condition.run;
  }
  c.tension = -dot(force, direction(row.d1));
  if (condition.index == 0) c.force = force;
}

}  // namespace pantin
