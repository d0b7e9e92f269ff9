// v = argmin ½ |v - v0|²_M + Σ ½ |P(y)|² / k,  y = γ - k (u + s),  s = friction |u_t| n of the round before; then γ = P(y), P the
// projection on Coulomb's cone. With k = stiffness / w the inner problem is convex, its gradient continuous.
#include <algorithm>
#include <cmath>

#include "contacts/solve/search.hpp"

namespace pantin {

namespace {

constexpr double softest = 40.0, first_stiffest = 1e3, stiffest = 1e5, tie_stiffness = 1e6;
constexpr std::uint32_t most_rounds = 20, most_iterations = 150, most_of_a_round = 60, most_of_a_stiff_round = 25;

enum class Phase : std::uint8_t { open, slides, sticks };

/// Of one contact: where its proximal step begins, and how stiff it is.
struct Cone {
  Vec3 from = zero3();  // [N s] γ of the round before
  double k = 0.0;       // [kg]
  double shift = 0.0;   // [m/s] s
};

struct Projected {
  Vec3 impulse;
  Phase phase;
  double d1, d2;   // direction of slip
  double turning;  // of the stiffness, across it
};

Projected project(const IslandContact& c, const Cone& cone, Vec3 u) {
  const double n = cone.from[0] - cone.k * (u[0] + cone.shift), a = cone.from[1] - cone.k * u[1],
               b = cone.from[2] - cone.k * u[2], t = std::sqrt(a * a + b * b), m = c.friction;
  const double d1 = t > 0.0 ? a / t : 1.0, d2 = t > 0.0 ? b / t : 0.0;
  if (t <= m * n) return {vec(n, a, b), Phase::sticks, d1, d2, 1.0};
  if (n <= -m * t) return {zero3(), Phase::open, d1, d2, 0.0};
  const double normal = (n + m * t) / (1.0 + m * m);
  return {vec(normal, m * normal * d1, m * normal * d2), Phase::slides, d1, d2, t > 0.0 ? m * normal / t : 0.0};
}

struct Proximal {
  ContactIsland& island;
  std::vector<Cone> cones;
  std::vector<Vec3> tie_from = {};
  std::vector<Projected> now = {}, used = {};
  std::vector<Mat3> stiffness = {};
  std::vector<BodyLoad> load = {}, change = {};
  std::vector<Vec3> du = {}, tie_du = {};
  bool has_factor = false;

  void set_stiffness(double s) {
    for (std::size_t k = 0; k < cones.size(); k++) cones[k].k = s / island.contacts[k].wn;
    has_factor = false;
  }
  void project_all() {
    now.resize(cones.size());
    for (std::size_t k = 0; k < cones.size(); k++) {
      IslandContact& c = island.contacts[k];
      if (!c.on) continue;
      now[k] = project(c, cones[k], c.u);
      c.impulse = now[k].impulse;
    }
    for (std::size_t k = 0; k < island.ties.size(); k++)
      island.ties[k].impulse = tie_from[k] - island.ties[k].u * (tie_stiffness / island.ties[k].w);
  }
  /// How much the velocities would change if what is not balanced acted on each body alone [m/s].
  double imbalance() {
    observe(island);
    project_all();
    unbalanced(island, load);
    double most = 0.0;
    for (std::size_t i = 0; i < load.size(); i++) {
      const IslandBody& b = island.bodies[i];
      most = std::fmax(most, norm(load[i].force) * b.inverse_mass);
      most = std::fmax(most, norm(b.mobility * load[i].moment) * b.reach);
    }
    return most;
  }
  bool factor_serves() const {
    if (!has_factor || used.size() != now.size()) return false;
    for (std::size_t k = 0; k < now.size(); k++) {
      if (!island.contacts[k].on) continue;
      const Projected &a = now[k], &b = used[k];
      if (a.phase != b.phase) return false;
      if (a.phase != Phase::slides) continue;
      if (std::fabs(a.turning - b.turning) > 0.02 * std::fmax(a.turning, b.turning)) return false;
      if (std::fabs(a.d1 * b.d2 - a.d2 * b.d1) > 0.02) return false;
    }
    return true;
  }
  void factorise_phases() {
    used = now;
    has_factor = true;
    stiffness.assign(cones.size(), zero33());
    for (std::size_t k = 0; k < cones.size(); k++) {
      const IslandContact& c = island.contacts[k];
      if (!c.on || used[k].phase == Phase::open) continue;
      if (used[k].phase == Phase::sticks) {
        stiffness[k] = identity33() * cones[k].k;
        continue;
      }
      const double m = c.friction;
      const Vec3 along = c.frame[1] * used[k].d1 + c.frame[2] * used[k].d2,
                 across = c.frame[2] * used[k].d1 - c.frame[1] * used[k].d2,
                 edge = (c.frame[0] + along * m) / std::sqrt(1.0 + m * m);
      stiffness[k] = outer(edge, edge) * cones[k].k + outer(across, across) * (cones[k].k * used[k].turning);
    }
    factorise(island, stiffness);
  }
  double slope_at(double x, double constant, double linear) const {
    double slope = constant + x * linear;
    for (std::size_t k = 0; k < cones.size(); k++) {
      const IslandContact& c = island.contacts[k];
      if (c.on) slope -= dot(project(c, cones[k], c.u + du[k] * x).impulse, du[k]);
    }
    return slope;
  }
  /// The step along the direction at which the slope of the convex function is 0, to a twentieth of its first.
  double step_length() {
    double constant = 0.0, linear = 0.0;
    for (std::size_t i = 0; i < island.bodies.size(); i++) {
      const IslandBody& b = island.bodies[i];
      const Vec3 p = change[i].force * b.mass, q = b.inertia * change[i].moment;
      constant += dot(p, b.v - b.v0) + dot(q, b.w - b.w0);
      linear += dot(p, change[i].force) + dot(q, change[i].moment);
    }
    for (std::size_t k = 0; k < island.ties.size(); k++) {
      constant -= dot(island.ties[k].impulse, tie_du[k]);
      linear += norm2(tie_du[k]) * (tie_stiffness / island.ties[k].w);
    }
    const double start = slope_at(0.0, constant, linear), full = slope_at(1.0, constant, linear);
    const double enough = 0.05 * std::fabs(start);
    if (full <= enough || !(start < 0.0)) return 1.0;
    double low = 0.0, high = 1.0, at_low = start, at_high = full, x = 1.0;
    for (int i = 0, side = 0; i < 40; i++) {
      x = low - at_low * (high - low) / (at_high - at_low);
      const double slope = slope_at(x, constant, linear);
      if (std::fabs(slope) < enough) break;
      if (slope > 0.0) {
        high = x;
        at_high = slope;
        if (side == 1) at_low *= 0.5;
        side = 1;
      } else {
        low = x;
        at_low = slope;
        if (side == -1) at_high *= 0.5;
        side = -1;
      }
    }
    return x;
  }
  void iterate() {
    change.resize(load.size());
    solve(island, load, change);
    for (std::size_t i = 0; i < change.size(); i++) {
      island.bodies[i].dv = change[i].force;
      island.bodies[i].dw = change[i].moment;
    }
    du.assign(cones.size(), zero3());
    for (std::size_t k = 0; k < cones.size(); k++) {
      const IslandContact& c = island.contacts[k];
      if (c.on) du[k] = to_frame(c, relative(c, island.bodies, &IslandBody::dv, &IslandBody::dw));
    }
    tie_du.resize(island.ties.size());
    for (std::size_t k = 0; k < tie_du.size(); k++)
      tie_du[k] = velocity_of(island.ties[k], island.bodies, &IslandBody::dv, &IslandBody::dw);
    const double x = step_length();
    for (std::size_t i = 0; i < change.size(); i++) {
      island.bodies[i].v += change[i].force * x;
      island.bodies[i].w += change[i].moment * x;
    }
  }
  void begin_round() {
    for (std::size_t k = 0; k < cones.size(); k++) {
      const IslandContact& c = island.contacts[k];
      cones[k].from = c.impulse;
      if (c.on) cones[k].shift = c.friction * std::sqrt(c.u[1] * c.u[1] + c.u[2] * c.u[2]);
    }
    for (std::size_t k = 0; k < island.ties.size(); k++) tie_from[k] = island.ties[k].impulse;
  }
};

double largest_stiffness(const ContactIsland& island) {
  double least = infinity, most = 0.0;
  for (const IslandBody& b : island.bodies) {
    least = std::fmin(least, b.mass);
    most = std::fmax(most, b.mass);
  }
  return std::clamp(most / least, first_stiffest, stiffest);
}

}  // namespace

SearchReport proximal_search(ContactIsland& island, double wanted) {
  SearchReport report;
  Proximal p{island, std::vector<Cone>(island.contacts.size())};
  p.tie_from.resize(island.ties.size());
  for (IslandContact& c : island.contacts) c.impulse = c.start;
  for (IslandTie& t : island.ties) t.impulse = t.start;
  apply_impulses(island);
  observe(island);
  for (std::size_t k = 0; k < p.cones.size(); k++) p.cones[k].from = island.contacts[k].start;
  for (std::size_t k = 0; k < p.tie_from.size(); k++) p.tie_from[k] = island.ties[k].start;
  double last = residual(island);
  report.residual = last;
  if (last <= island.tolerance) return report;
  set_base(island, tie_stiffness);
  const double top = largest_stiffness(island), scale = 1e8 * island.tolerance;
  double stiff = softest;
  const auto adapt = [&](double most) {
    const double s = std::clamp(8.0 * scale / last, softest, std::fmin(most, top));
    if (s > 1.5 * stiff) p.set_stiffness(stiff = s);
  };
  p.set_stiffness(stiff);
  adapt(first_stiffest);
  for (std::uint32_t round = 0; round < most_rounds; round++) {
    const double goal = std::fmax(0.3 * wanted, 0.1 * std::fmin(last, scale));
    const std::uint32_t most = stiff > first_stiffest ? most_of_a_stiff_round : most_of_a_round;
    double off = p.imbalance();
    for (std::uint32_t i = 0; i < most && (off > goal || i == 0); i++) {
      if (!p.factor_serves()) {
        p.factorise_phases();
        report.factorisations++;
      }
      p.iterate();
      report.iterations++;
      off = p.imbalance();
    }
    const double found = std::fmax(residual(island), off);
    const bool slow = found > 0.25 * last;
    last = found;
    report.residual = found;
    if (found <= wanted || report.iterations >= most_iterations) break;
    p.begin_round();
    if (slow && stiff < top)
      p.set_stiffness(stiff = std::fmin(5.0 * stiff, top));
    else
      adapt(100.0 * stiff);
  }
  apply_impulses(island);
  observe(island);
  return report;
}

}  // namespace pantin
