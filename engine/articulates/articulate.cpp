#include "articulates/articulate.hpp"

#include <algorithm>

namespace pantin {

void load(Node& n, const Model& model, Vec3 gravity) {
  if (n.is_body) {
    const Motion& m = model.motion[n.slot];
    n.x0 = m.x;
    n.p0 = m.p;
    n.P0 = m.angular;
    n.q0 = m.q;
    n.R0 = matrix(m.q);
    n.O0 = n.inverse_inertia * n.P0;
    n.force = gravity * n.mass + m.force;
    n.torque = m.torque;
  } else {
    const FreeMotion& m = model.free_motion[n.slot];
    n.x0 = m.x;
    n.p0 = m.v * n.mass;
    n.P0 = n.O0 = n.torque = zero3();
    n.q0 = {};
    n.R0 = identity33();
    n.force = gravity * n.mass + model.points.at_slot(n.slot).force;
  }
  n.x1 = n.x0;
  n.p1 = n.p0;
  n.P1 = n.P0;
  n.q1 = n.q0;
  n.R1 = n.R0;
}

void store(const Node& n, Model& model) {
  if (n.is_body) {
    Motion& m = model.motion[n.slot];
    m.x = n.x0;
    m.p = n.p0;
    m.angular = n.P0;
    m.q = n.turns ? normalised(n.q0) : n.q0;
  } else {
    model.free_motion[n.slot] = {n.x0, n.p0 * n.inverse_mass};
  }
}

namespace {

void load_constraint(Condition& row, const Constraint& c, double total_mass) {
  row.whole0 = c.previous + c.previous_away;
  row.whole1 = c.place + c.away;
  row.velocity = c.velocity + c.away_rate;
  row.whole_length0 = c.length + c.previous_excess;
  row.whole_length1 = c.length + c.excess;
  row.length_rate = c.excess_rate;
  row.max_force = c.max_force;
  row.stiffness = total_mass / (c.time_constant * c.time_constant);  // critically damped for all that hangs at it
  row.damping = 2.0 * total_mass / c.time_constant;
}

}  // namespace

void load(Articulate& a, const Model& model, Vec3 gravity) {
  for (Node& n : a.nodes) load(n, model, gravity);
  for (Condition& c : a.conditions) load_constraint(c, model.constraints[c.constraint], a.total_mass);
}

void disturb(Articulate& a) {
  a.edited = true;
  a.last_h = 0.0;
}

void store(const Articulate& a, Model& model) {
  for (const Node& n : a.nodes) store(n, model);
  for (const Row& row : a.rows)
    if (row.centre) model.points[row.centre].row_force = zero3();
  for (const Row& row : a.rows) {
    if (row.condition >= 0) {
      Constraint& c = model.constraints[condition(a, row).constraint];
      c.force = row.f;
      c.tension = -dot(row.f, direction(row.d1));
      continue;
    }
    model.points[row.member].row_force = row.f;
    model.points[row.centre].row_force -= row.f;
  }
}

double kinetic_energy(const Articulate& a) {
  double t = 0.0;
  for (const Node& n : a.nodes) t += kinetic_energy(n);
  return t;
}

void measure_gaps(Articulate& a) {
  a.gaps = {};
  for (const Row& row : a.rows) {
    if (row.kind == RowKind::rigid) {
      a.gaps.points = std::max(a.gaps.points, norm(row.d1));
      a.gaps.open = std::max(a.gaps.open, norm(row.d1 - row.offset));
    } else if (row.kind == RowKind::rod) {
      const Condition& c = condition(a, row);
      const double gap = norm(row.d1) - c.length;
      a.gaps.rods = std::max(a.gaps.rods, std::fabs(gap));
      a.gaps.open = std::max(a.gaps.open, std::fabs(gap - c.accepted));
    }
  }
}

}  // namespace pantin
