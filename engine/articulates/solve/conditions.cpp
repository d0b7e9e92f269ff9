#include "articulates/solve/conditions.hpp"

#include <algorithm>

#include "articulates/solve/newton.hpp"
#include "base/functions.hpp"
#include "model/path.hpp"

namespace pantin {

namespace {

bool by_points(const Constraint& c) { return static_cast<bool>(c.a); }

RowPlan between_points(const Constraint& c, RowKind kind) {
  return {kind, false, c.a, c.b, {}, {}, zero3(), zero3(), 0};
}
RowPlan angular_row(const Constraint& c, RowKind kind) {
  return {kind, true, {}, {}, c.body_a, c.body_b, c.axis_a, c.axis_b, 0};
}

Quat quaternion_of(Vec3 rotation) {
  const double angle = norm(rotation);
  const Vec3 u = direction(rotation) * functions::sin(0.5 * angle);
  return {functions::cos(0.5 * angle), u[0], u[1], u[2]};
}

bool equal(const Quat& a, const Quat& b) { return a.w == b.w && a.x == b.x && a.y == b.y && a.z == b.z; }

/// Frames of the bodies to principal axes: `turn` of a constraint as one between the nodes.
Quat between_nodes(const Model& model, const Constraint& c, const Quat& turn) {
  const Quat of_a = turn * model.bodies[c.body_a].axes;
  return c.body_b ? conjugate(model.bodies[c.body_b].axes) * of_a : of_a;
}

void load_angular_row(Condition& condition, const Row& row, const Model& model, const Constraint& c) {
  const Quat to_b = c.body_b ? conjugate(model.bodies[c.body_b].axes) : Quat{};
  condition.whole_turn0 = model.plane.about(between_nodes(model, c, c.previous_turn));
  condition.whole_turn1 = model.plane.about(between_nodes(model, c, c.turn));
  condition.axis = condition.axis0 = condition.axis1 = model.plane.axis(rotate(to_b, c.axis_b));
  condition.angle0 = condition.angle1 = c.angle;
  condition.whole_length0 = row.lever * (c.previous_length + c.previous_excess);
  condition.whole_length1 = row.lever * (c.length + c.excess);
  condition.length_rate = row.lever * (c.length_rate + c.excess_rate);
  condition.low = row.lever * c.low;
  condition.high = row.lever * c.high;
  condition.upper = c.max_torque / row.lever;
  const double given = norm(row.f), driven_back = std::fmin(1.001 * condition.stalled, condition.upper);
  if (given < 0.5 * condition.stalled || given > driven_back) condition.stalled = infinity;
  condition.lower = -condition.upper;
  condition.velocity = zero3();
  condition.whole0 = condition.whole1 = zero3();
  if (c.kind == ConstraintKind::orient) {
    condition.whole_turn0 = quaternion_of(model.plane.about(c.previous_away)) * condition.whole_turn0;
    condition.whole_turn1 = quaternion_of(model.plane.about(c.away)) * condition.whole_turn1;
    condition.velocity = model.plane.about(c.spin + c.away_rate) * row.lever;
  } else if (row.kind == RowKind::axis) {  // an align that is drawn in turns its second axis
    condition.velocity = c.away_rate * row.lever;
    if (c.body_b) condition.velocity = rotate(orientation(model, c.body_b), condition.velocity);
    condition.velocity = model.plane.about(condition.velocity);
    condition.whole0 = model.plane.about(rotate(to_b, c.previous_away));
    condition.whole1 = model.plane.about(rotate(to_b, c.away));
  }
  condition.by_speed = c.by_speed;
  condition.start_rate = row.lever * c.previous_rate;
  condition.bent = c.bend.straight() ? Bent::nothing : c.attitude ? Bent::turn : Bent::length;
  condition.bend = c.bend.mapped(row.lever, [&](Vec3 v) { return c.attitude ? model.plane.about(v) : v * row.lever; });
  condition.works = c.kind == ConstraintKind::motor || condition.ranged ||
                    condition.whole_length0 != condition.whole_length1 ||
                    !equal(condition.whole_turn0, condition.whole_turn1) || !same(condition.whole0, condition.whole1);
}

/// Whether a segment of a string cannot change its length.
bool is_fixed(const Model& model, const Passage& from, const Passage& to) {
  if (!from.point || !to.point) return !from.point && !to.point;
  const BodyId body = model.points[from.point].body;
  return body && body == model.points[to.point].body;
}

std::vector<RowPlan> segments(const Model& model, const Constraint& c) {
  std::vector<RowPlan> plans;
  for (std::uint32_t i = 0; i + 1 < c.passages.size(); i++) {
    PointId from = c.passages[i].point, to = c.passages[i + 1].point;
    if (is_fixed(model, c.passages[i], c.passages[i + 1])) continue;
    if (!from) std::swap(from, to);
    plans.push_back({RowKind::segment, false, from, to, {}, {}, zero3(), zero3(), i});
  }
  return plans;
}

double fixed_length(const Model& model, const Constraint& c) {
  const auto at = [&](const Passage& p) { return p.point ? position(model, p.point) : p.position; };
  double sum = 0.0;
  for (std::size_t i = 1; i < c.passages.size(); i++)
    if (is_fixed(model, c.passages[i - 1], c.passages[i])) sum += norm(at(c.passages[i]) - at(c.passages[i - 1]));
  return sum;
}

void load_segment(Condition& condition, const Model& model, const Constraint& c) {
  const Passage &from = c.passages[condition.index], &to = c.passages[condition.index + 1];
  condition.whole0 = condition.whole1 = model.plane.along(from.point ? to.position : from.position);
  condition.velocity = zero3();
  const double fixed = fixed_length(model, c);
  condition.whole_length0 -= fixed;
  condition.whole_length1 -= fixed;
}

}  // namespace

std::vector<RowPlan> plan_rows(const Model& model, const Constraint& c) {
  switch (c.kind) {
    case ConstraintKind::nail: break;
    case ConstraintKind::follow:
      if (std::isfinite(c.max_force)) return {between_points(c, RowKind::soft)};
      break;
    case ConstraintKind::rod: return {between_points(c, RowKind::rod)};
    case ConstraintKind::join:
      return {between_points(c, std::isfinite(c.max_force) ? RowKind::soft : RowKind::attract)};
    case ConstraintKind::on_plane: return {between_points(c, RowKind::plane)};
    case ConstraintKind::on_path: return {between_points(c, RowKind::path)};
    case ConstraintKind::string: return segments(model, c);
    case ConstraintKind::limit: return {by_points(c) ? between_points(c, RowKind::rod) : angular_row(c, RowKind::turn)};
    case ConstraintKind::motor: return {angular_row(c, RowKind::turn)};
    case ConstraintKind::axis: return {angular_row(c, RowKind::axis)};
    case ConstraintKind::align: return {angular_row(c, c.length == 0.0 ? RowKind::axis : RowKind::align)};
    case ConstraintKind::orient: return {angular_row(c, RowKind::rigid)};
    case ConstraintKind::weld:
      return {{RowKind::rigid, false, {}, {}, c.body_a, c.body_b, c.arm_a, c.arm_b, 0}, angular_row(c, RowKind::rigid)};
  }
  return {between_points(c, RowKind::rigid)};
}

void load(Condition& condition, const Row& row, const Model& model, double total_mass) {
  const Constraint& c = model.constraints[condition.constraint];
  condition.ranged =
      c.kind == ConstraintKind::limit || c.kind == ConstraintKind::string || (c.path && !c.path->closed());
  condition.held_before = condition.held;
  if (row.lever > 0.0) return load_angular_row(condition, row, model, c);
  condition.whole0 = model.plane.along(c.previous + c.previous_away);
  condition.whole1 = model.plane.along(c.position + c.away);
  condition.velocity = model.plane.along(c.velocity + c.away_rate);
  condition.whole_length0 = c.previous_length + c.previous_excess;
  condition.whole_length1 = c.length + c.excess;
  condition.length_rate = c.length_rate + c.excess_rate;
  condition.bent = c.bend.straight() ? Bent::nothing : c.target ? Bent::position : Bent::length;
  condition.bend = c.bend.mapped(1.0, [&](Vec3 v) { return c.target ? model.plane.along(v) : v; });
  condition.low = c.low;
  condition.high = c.high;
  condition.normal = model.plane.axis(c.axis_a);
  condition.path = c.path.get();
  if (c.path) {
    condition.angle0 = condition.angle1 = c.along;
    const Vec3 at = c.path->positions()[0], height = at - model.plane.along(at);
    condition.whole0 -= height;
    condition.whole1 -= height;
  }
  if (c.kind == ConstraintKind::string) load_segment(condition, model, c);
  condition.works = row.kind == RowKind::soft || condition.ranged || condition.whole_length1 != condition.whole_length0;
  condition.max_force = c.max_force;
  condition.stiffness = total_mass / (c.time_constant * c.time_constant);  // critically damped for all that hangs at it
  condition.damping = 2.0 * total_mass / c.time_constant;
}

void store(const Condition& condition, const Row& row, Vec3 force, Constraint& c) {
  if (row.lever > 0.0) {
    c.torque = force * row.lever;
    c.angle = condition.angle1;
    return;
  }
  if (c.path) c.along = condition.angle1;
  c.tension = -dot(force, direction(row.d1));
  if (condition.index == 0) c.force = force;
}

double inertia_about(const Articulate& a, Vec3 position) {
  double sum = 0.0;
  for (const Node& n : a.nodes) sum += n.mass * norm2(n.x0 - position) + largest(n.inertia);
  return sum;
}

namespace {

bool is_motor(const Row& row, const Condition& c) { return row.kind == RowKind::turn && !c.ranged; }

double displacement_of(const Condition& c) { return c.whole_length1 - c.whole_length0; }

}  // namespace

bool stall_motors(Articulate& a, double h) {
  const bool limits =
      std::any_of(a.conditions.begin(), a.conditions.end(), [](const Condition& c) { return c.ranged; });
  bool stalled = false;
  for (Condition& c : a.conditions) {
    const Row& r = row(a, c);
    const double displacement = std::fabs(displacement_of(c));
    const bool yields = limits || std::isfinite(c.upper);
    if (!is_motor(r, c) || !yields || std::isfinite(c.stalled) || displacement == 0.0) continue;
    const double inertia = inertia_about(a, a.nodes[static_cast<std::size_t>(r.a)].x0) / (r.lever * r.lever);
    c.stalled = std::fmin(c.upper, 2.0 * norm(r.f) + 0.01 * inertia * displacement / (h * h));
    c.yielding = displacement / c.stalled;
    stalled = true;
  }
  return stalled;
}

void strengthen_stalled(Articulate& a, double h) {
  constexpr double most_needed = 1e4;  // more would leave few digits to what else there is
  for (Condition& c : a.conditions) {
    if (std::isinf(c.stalled) || std::isinf(c.upper)) continue;
    const double displacement = std::fabs(displacement_of(c)),
                 enough = most_needed * displacement / (h * h * mobility(a, row(a, c)));
    const double more = std::fmin(std::fmin(10.0 * c.stalled, c.upper), enough);
    if (!(more > c.stalled)) continue;
    c.stalled = more;
    c.yielding = displacement / more;
  }
}

double speed(const Condition& c, double at) {
  return c.start_rate + (c.length_rate - c.start_rate) * at + c.bend.at(at)[0];
}

void set_conditions(Articulate& a, double h, double from, double to) {
  for (Condition& c : a.conditions) {
    const Vec3 displacement = c.whole1 - c.whole0;
    c.position0 = c.whole0 + displacement * from;
    c.position1 = to == 1.0 ? c.whole1 : c.whole0 + displacement * to;
    c.length = to == 1.0 ? c.whole_length1 : c.whole_length0 + (c.whole_length1 - c.whole_length0) * to;
    if (c.bent == Bent::position) {
      c.position0 += c.bend.at(from);
      c.position1 += c.bend.at(to);
    }
    if (c.bent == Bent::length && !c.by_speed) c.length += c.bend.at(to)[0];
    const Row& r = row(a, c);
    if (r.lever == 0.0) continue;
    if (c.by_speed)
      c.length =
          r.lever * (c.angle0 + 2.0 * functions::atan(0.5 * h * (to - from) * speed(c, 0.5 * (from + to)) / r.lever));
    c.turn0 = between(c.whole_turn0, c.whole_turn1, from);
    c.turn1 = between(c.whole_turn0, c.whole_turn1, to);
    if (c.bent == Bent::turn) {
      c.turn0 = quaternion_of(c.bend.at(from)) * c.turn0;
      c.turn1 = quaternion_of(c.bend.at(to)) * c.turn1;
    }
    if (r.kind != RowKind::axis) continue;
    c.axis0 = rotate(quaternion_of(c.position0), c.axis);
    c.axis1 = rotate(quaternion_of(c.position1), c.axis);
  }
}

}  // namespace pantin
