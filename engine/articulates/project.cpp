#include "articulates/project.hpp"

#include <algorithm>

#include "articulates/newton.hpp"
#include "articulates/rows.hpp"

namespace pantin {

namespace {

/// The right side alone, on a factor at hand.
constexpr System same_system{Arms::end, 0.0, 0.0, -1.0};

Vec3 end_velocity(const Node& n, Vec3 arm) {
  return n.p0 * n.inverse_mass + (n.turns ? cross(n.R0 * n.O0, arm) : zero3());
}

/// Sets the residuals of the rows to their forbidden velocities; returns the largest [m/s].
double forbidden_velocity(Articulate& a) {
  double worst = 0.0;
  for (Row& row : a.rows) {
    if (row.kind == RowKind::limited) {
      row.residual = zero3();
      continue;
    }
    const Node& first = a.nodes[static_cast<std::size_t>(row.a)];
    Vec3 v = end_velocity(first, row.ra1);
    v -= row.b < 0 ? condition(a, row).velocity : end_velocity(a.nodes[static_cast<std::size_t>(row.b)], row.rb1);
    if (row.kind == RowKind::rod) {
      const Vec3 n = direction(row.d1);
      v = n * dot(n, v);
    }
    row.residual = v;
    worst = std::max(worst, norm2(v));
  }
  return std::sqrt(worst);
}

void add_impulse(Node& n, Vec3 arm, Vec3 impulse) {
  n.p0 += impulse;
  if (!n.turns) return;
  n.P0 += transposed_times(n.R0, cross(arm, impulse));
  n.O0 = n.inverse_inertia * n.P0;
}

/// Finishes the solution of the half solved right side and applies the impulses; returns the work of moving anchors [J].
double apply_projection(Articulate& a) {
  double work = 0.0;
  for (std::size_t k = a.rows.size(); k-- > 0;) {
    const Row& row = a.rows[k];
    a.factor.substitute_back(static_cast<std::uint32_t>(k), a.right_side.data());
    if (row.kind == RowKind::limited) continue;
    Vec3 impulse = a.right_side[k];
    if (row.kind == RowKind::rod) {
      const Vec3 n = direction(row.d1);
      impulse = n * dot(n, impulse);
    }
    add_impulse(a.nodes[static_cast<std::size_t>(row.a)], row.ra1, impulse);
    if (row.b >= 0)
      add_impulse(a.nodes[static_cast<std::size_t>(row.b)], row.rb1, impulse * -1.0);
    else
      work += dot(impulse, condition(a, row).velocity);
  }
  return work;
}

void save_momenta(Articulate& a) {
  for (Node& n : a.nodes) {
    n.p1 = n.p0;
    n.P1 = n.P0;
  }
}

void restore_momenta(Articulate& a) {
  for (Node& n : a.nodes) {
    n.p0 = n.p1;
    n.P0 = n.P1;
    n.O0 = n.inverse_inertia * n.P0;
  }
}

void factorise_exactly(Articulate& a, double epsilon) {
  for (Row& row : a.rows)
    if (row.kind != RowKind::rigid) rule(row).project(row, condition(a, row));
  double scale = 0.0;
  if (!a.all_rigid)
    for (const Row& row : a.rows) scale = std::max(scale, mobility(a, row));
  factorise(a, {Arms::end, epsilon, scale, -1.0});
}

/// Solves for the velocities' residuals on a new factor, then again on that factor until nothing forbidden is left;
/// returns the work of moving anchors [J].
double iterate_projection(Articulate& a, int most, double speed, double epsilon) {
  double last = infinity, work = 0.0;
  for (int i = 0; i < most; i++) {
    const double v = forbidden_velocity(a);
    if (v < 1e-13 * speed || v > 0.5 * last) break;
    last = v;
    if (i == 0)
      factorise_exactly(a, epsilon);
    else
      reuse_factor(a, same_system);
    work += apply_projection(a);
  }
  return work;
}

double fastest(const Articulate& a) {
  double v2 = 0.0;
  for (const Node& n : a.nodes) v2 = std::max(v2, norm2(n.p0) * n.inverse_mass * n.inverse_mass);
  for (const Condition& c : a.conditions) v2 = std::max(v2, norm2(c.velocity));
  return std::sqrt(v2);
}

/// The step's own factor is a cheap approximation of S1; false where it does not serve.
bool project_with_newton_factor(Articulate& a, double& work) {
  if (!a.all_rigid || !a.has_factor) return false;
  if (a.projection_wait > 0) {
    a.projection_wait--;
    return false;
  }
  save_momenta(a);
  const double kinetic = kinetic_energy(a), before = forbidden_velocity(a);
  reuse_factor(a, same_system);
  const double done = apply_projection(a);
  const double after = forbidden_velocity(a);
  if (after <= 0.2 * before + 1e-12 * fastest(a) && kinetic_energy(a) <= kinetic * (1.0 + 1e-12) + std::fabs(done)) {
    work += done;
    return true;
  }
  restore_momenta(a);
  a.projection_wait = 100;
  return false;
}

/// The rigid motion whose momentum is kept by symmetry: velocity V at X, spin w.
struct RigidMotion {
  Vec3 X = zero3(), V = zero3(), w = zero3();
};

Mat3 inertia_about(const Articulate& a, Vec3 X) {
  Mat3 total = zero33();
  for (const Node& n : a.nodes) {
    Mat3 scaled = n.R0;
    for (int i = 0; i < 3; i++) scaled[i] *= n.inertia[i] * n.coupled[i];
    if (n.turns) total += times_transposed(scaled, n.R0);
    const Vec3 d = n.x0 - X;
    total += (identity33() * norm2(d) - outer(d, d)) * n.mass;
  }
  return total;
}

Vec3 angular_momentum_about(const Articulate& a, Vec3 X) {
  Vec3 L = zero3();
  for (const Node& n : a.nodes) L += cross(n.x0 - X, n.p0) + n.R0 * (n.P0 * n.coupled);
  return L;
}

/// Spin of the locked articulate about X with angular momentum L: J⁻¹ L, or 0 where J is singular (all on a line).
Vec3 locked_spin(const Articulate& a, Vec3 X, Vec3 L) {
  const Mat3 J = inertia_about(a, X);
  const double t = trace(J);
  const double volume = dot(J[0], cross(J[1], J[2]));
  return volume > 1e-12 * t * t * t ? inverse(J) * L : zero3();
}

/// Anchors on the world leave rigid motions free: none: all six; one place: the turn about it, of which gravity keeps
/// only the part about its own direction; a line: the turn about that line, if gravity is along it; else none.
RigidMotion kept_motion(const Articulate& a, Vec3 gravity) {
  RigidMotion m;
  bool pinned = false, line = false;
  Vec3 axis = zero3();
  for (const Row& row : a.rows) {
    if (row.b >= 0) continue;
    const Vec3 place = condition(a, row).whole1;
    if (!pinned) {
      pinned = true;
      m.X = place;
      continue;
    }
    const Vec3 d = place - m.X;
    if (norm(d) <= 1e-9 * a.length) continue;
    const Vec3 u = direction(d);
    if (line && norm(cross(u, axis)) > 1e-9) return m;
    line = true;
    axis = u;
  }
  if (!pinned) {
    double mass = 0.0;
    Vec3 momentum = zero3();
    for (const Node& n : a.nodes) {
      m.X += n.x0 * n.mass;
      momentum += n.p0;
      mass += n.mass;
    }
    m.X = m.X / mass;
    m.V = momentum / mass;
    m.w = locked_spin(a, m.X, angular_momentum_about(a, m.X));
    return m;
  }
  const double g = norm(gravity);
  if (!line && g == 0.0) {
    m.w = locked_spin(a, m.X, angular_momentum_about(a, m.X));
    return m;
  }
  const Vec3 down = g > 0.0 ? gravity / g : axis;
  if (line && norm(cross(down, axis)) > 1e-9) return m;
  const Vec3 turn = line ? axis : down;
  const double inertia = dot(turn, inertia_about(a, m.X) * turn);
  if (inertia > 0.0) m.w = turn * (dot(turn, angular_momentum_about(a, m.X)) / inertia);
  return m;
}

/// Scales the motion relative to the kept rigid motion so that the kinetic energy is `kinetic` again [J]. Spin that
/// nothing couples to stays as it is.
void return_energy(Articulate& a, double kinetic, Vec3 gravity) {
  const RigidMotion rigid = kept_motion(a, gravity);
  const auto rigid_p = [&](const Node& n) { return (rigid.V + cross(rigid.w, n.x0 - rigid.X)) * n.mass; };
  const auto rigid_P = [&](const Node& n) { return n.inertia * transposed_times(n.R0, rigid.w); };
  double relative = 0.0;
  for (const Node& n : a.nodes) {
    const Vec3 p = n.p0 - rigid_p(n), P = (n.P0 - rigid_P(n)) * n.coupled;
    relative += 0.5 * (norm2(p) * n.inverse_mass + dot(P, n.inverse_inertia * P));
  }
  const double now = kinetic_energy(a);
  if (!(relative > 1e-9 * now)) return;
  const double factor = std::min(1.2, std::sqrt(std::max(0.0, 1.0 + (kinetic - now) / relative)));
  for (Node& n : a.nodes) {
    const Vec3 p = rigid_p(n);
    n.p0 = p + (n.p0 - p) * factor;
    if (!n.turns) continue;
    n.P0 += (n.P0 - rigid_P(n)) * n.coupled * (factor - 1.0);
    n.O0 = n.inverse_inertia * n.P0;
  }
}

bool may_return(const Articulate& a) {
  for (const Row& row : a.rows)
    if (row.kind == RowKind::limited) return false;
  for (const Condition& c : a.conditions)
    if (norm2(c.velocity) > 0.0) return false;
  return !a.safe;
}

}  // namespace

void project_velocities(Articulate& a, const DriftSettings& settings, DriftReport& report) {
  if (a.safe) return;
  const double kinetic = kinetic_energy(a);
  if (!project_with_newton_factor(a, report.work)) {
    report.projections++;
    a.has_factor = false;
    report.work += iterate_projection(a, 1, fastest(a), 1e-10);
  }
  if (settings.energy_return && may_return(a)) return_energy(a, kinetic, settings.gravity);
}

void make_consistent(Articulate& a) {
  const double speed = fastest(a);
  double anchors = 0.0;
  for (const Condition& c : a.conditions) anchors = std::max(anchors, norm2(c.velocity));
  const double sane = std::max(1.001 * kinetic_energy(a), 0.5 * a.total_mass * anchors);
  save_momenta(a);
  for (double epsilon = 1e-10;; epsilon *= 100.0) {
    iterate_projection(a, 3, speed, epsilon);
    if (kinetic_energy(a) <= sane || epsilon > 1e-3) break;
    restore_momenta(a);
  }
  a.has_factor = false;
}

}  // namespace pantin
