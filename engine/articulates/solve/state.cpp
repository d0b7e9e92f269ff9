#include "articulates/solve/state.hpp"

#include <algorithm>
#include <tuple>

#include "articulates/solve/couplings.hpp"
#include "articulates/solve/row_gaps.hpp"
#include "constraints/load.hpp"
#include "constraints/stiff.hpp"

namespace pantin {

void load(Node& n, const Model& model, Vec3 gravity) {
  if (n.is_body) {
    const Motion& m = model.motion[n.slot];
    n.x0 = model.plane.along(m.x);
    n.p0 = m.p;
    n.P0 = m.angular;
    n.q0 = m.q;
    n.R0 = matrix(m.q);
    n.spin0 = n.inverse_inertia * n.P0;
    n.force = gravity * n.mass + m.force;
    n.torque = m.torque;
  } else {
    const FreeMotion& m = model.free_motion[n.slot];
    n.x0 = model.plane.along(m.x);
    n.p0 = m.v * n.mass;
    n.P0 = n.spin0 = n.torque = zero3();
    n.q0 = {};
    n.R0 = identity33();
    n.force = gravity * n.mass + model.points.at_slot(n.slot).force;
  }
}

void store(const Node& n, Model& model) {
  if (n.is_body) {
    Motion& m = model.motion[n.slot];
    m.x = model.plane.beside(n.x0, m.x);
    m.p = n.p0;
    m.angular = n.P0;
    m.q = n.turns ? normalised(n.q0) : n.q0;
  } else {
    FreeMotion& m = model.free_motion[n.slot];
    m = {model.plane.beside(n.x0, m.x), n.p0 * n.inverse_mass};
  }
}

void load(Articulate& a, const Model& model, Vec3 gravity) {
  a.by_tree = false;
  for (Node& n : a.nodes) load(n, model, gravity);
  load_conditions(a, model);
}

void load_conditions(Articulate& a, const Model& model) {
  for (Condition& c : a.conditions)
    if (!c.stiff) load(c, row(a, c), model, a.total_mass);
}

void begin_report(Articulate& a) {
  a.report = {};
  for (Condition& c : a.conditions) std::fill(c.energy_given.begin(), c.energy_given.end(), 0.0);
}

void disturb(Articulate& a) {
  wake(a);
  a.edited = true;
  a.last_h = a.symmetric_h = 0.0;
}

void store(const Articulate& a, Model& model) {
  for (const Node& n : a.nodes) store(n, model);
  for (const Row& row : a.rows)
    if (row.star_point) model.points[row.star_point].row_force = zero3();
  for (std::size_t k = 0; k < a.rows.size(); k++) {
    const Row& row = a.rows[k];
    if (pulls_by_law(row)) continue;
    const Vec3 f = exerted_force(a, k);
    if (row.condition >= 0) {
      if (!model.constraints.alive(condition(a, row).constraint)) continue;  // it broke in this step
      store(condition(a, row), row, model, f, model.constraints[condition(a, row).constraint]);
      continue;
    }
    model.points[row.member].row_force = f;
    model.points[row.star_point].row_force -= f;
  }
}

void store_early(Articulate& a, Model& model) {
  for (Node& n : a.nodes) {
    if (n.is_body) {
      const Motion& m = model.motion[n.slot];
      std::tie(n.x1, n.p1, n.P1, n.q1) = std::tie(m.x, m.p, m.angular, m.q);
    } else {
      const FreeMotion& m = model.free_motion[n.slot];
      std::tie(n.x1, n.p1) = std::tie(m.x, m.v);
    }
  }
  store(a, model);
  a.stored = true;
}

void take_back(const Articulate& a, Model& model) {
  for (const Node& n : a.nodes) {
    if (n.is_body) {
      Motion& m = model.motion[n.slot];
      std::tie(m.x, m.p, m.angular, m.q) = std::tie(n.x1, n.p1, n.P1, n.q1);
    } else {
      model.free_motion[n.slot] = {n.x1, n.p1};
    }
  }
}

void begin_exerted(Articulate& a) {
  const double sign = symmetric_sign(a);
  a.exerted.resize(a.rows.size());
  for (std::size_t k = 0; k < a.rows.size(); k++) a.exerted[k] = a.symmetric_impulses[k] * sign;
  a.exerted_time = 0.0;
  a.sums_impulses = true;
}
void add_impulses_exerted(Articulate& a) {
  for (std::size_t k = 0; k < a.rows.size(); k++) a.exerted[k] += a.impulses[k];
}
void add_forces_exerted(Articulate& a, double h) {
  for (std::size_t k = 0; k < a.rows.size(); k++) a.exerted[k] += a.rows[k].f * h;
  a.exerted_time += h;
}

void tell_tensions(const Articulate& a, Model& model) {
  for (const Condition& c : a.conditions)
    if (c.stiff) model.connections[c.stiff->connection].tension = -dot(row(a, c).f, direction(row(a, c).d1));
}

double kinetic_energy(const Articulate& a) {
  double t = 0.0;
  for (const Node& n : a.nodes) t += kinetic_energy(n);
  return t;
}

double add_energies_of_solved_laws(Articulate& a, double times) {
  const auto end = [&](std::int32_t node, Vec3 arm) {
    const Node& n = a.nodes[static_cast<std::size_t>(node)];
    return n.turns ? n.x0 + n.R0 * arm : n.x0;
  };
  double all = 0.0;
  for (Condition& c : a.conditions) {
    if (!c.stiff) continue;
    const Row& of = row(a, c);
    const Vec3 d = end(of.a, of.la) - (of.b < 0 ? c.position1 : end(of.b, of.lb));
    all += add_energies(*c.stiff, d, times, c.energy_given);
  }
  return all;
}

NodeTotals totals_of(const Articulate& a) {
  NodeTotals t;
  double unsound = 0.0;
  for (const Node& n : a.nodes) {
    t.kinetic += kinetic_energy(n);
    t.mass_position += n.x0 * n.mass;
    unsound += 0.0 * (n.q0.w + n.q0.x + n.q0.y + n.q0.z);
  }
  t.finite = std::isfinite(t.kinetic + unsound) && finite(t.mass_position);
  return t;
}

namespace {

double gap_with_accepted(const Articulate& a, const Row& row, double open) {
  const double all = open + norm(row.offset) + std::fabs(condition(a, row).accepted);
  return is_coupled(row) ? all * motion_per_gap(a, row) : all;
}

}  // namespace

void measure_gaps(Articulate& a) {
  a.gaps = {};
  for (const Row& row : a.rows) {
    if (is_soft(row)) continue;
    const double open = norm(gap(a, row));
    a.gaps.unaccepted = std::max(a.gaps.unaccepted, open);
    if (is_rigid(row) && row.lever == 0.0)
      a.gaps.points = std::max(a.gaps.points, norm(row.d1));
    else
      a.gaps.others = std::max(a.gaps.others, gap_with_accepted(a, row, open));
  }
}

bool struck(const Articulate& a) {
  return std::any_of(a.conditions.begin(), a.conditions.end(),
                     [](const Condition& c) { return c.held && !c.held_before; });
}

}  // namespace pantin
