// 0 ≤ γ ⊥ s ≥ 0 as γ + s - √((γ - s)² + 4τ) = 0 with τ towards 0 (Fischer 1992; Kanzow 1996), of the normal impulse with the
// normal speed, and of the slack µγ_n - |γ_t| with the speed of slip. Impulses count times w here, so that all are speeds.
#include <algorithm>
#include <cmath>

#include "contacts/solve/search.hpp"

namespace pantin {

namespace {

constexpr double tie_stiffness = 1e7;                          // of 1 / w
constexpr double least_stiffness = 1e3, most_stiffness = 1e8;  // of contacts, of 1 / w
constexpr double smoothing = 0.1;                              // √τ of the residual

/// dγ = offset - stiffness ds makes the smoothed law hold to first order.
struct Slope {
  double offset, stiffness;
  double follows = 0.0;  ///< of g, by how much the root moves with it
};

Slope smoothed(double g, double s, double tau, double softness) {
  const double x = g - s, r = std::sqrt(x * x + 4.0 * tau) + 1e-300, size = std::fabs(x);
  const double low = 4.0 * tau / (r * (r + size) + 1e-300), high = (r + size) / r;
  const double by_g = x > 0.0 ? low : high, by_s = x > 0.0 ? high : low;
  const double value = x > 0.0 ? 2.0 * s - r * low : 2.0 * g - r * low;
  const double slope = by_g + by_s * softness;
  return {-value / slope, by_s / slope, by_g / slope};
}

/// A contact's law to first order: normal, along the slip, across it.
struct Linear {
  Vec3 offset = zero3(), stiffness = zero3();
  double d1 = 1.0, d2 = 0.0;  // the slip's direction by t1 and t2
  double follows = 0.0;       // change of the impulse along the slip by that of the normal one
};

Linear linearise(const IslandContact& c, double tau, double stiffest) {
  Linear l;
  const Slope normal =
      smoothed(c.impulse[0] * c.wn, c.u[0] + c.compliance * c.impulse[0], tau, 1.0 / stiffest + c.compliance / c.wn);
  l.offset[0] = normal.offset;
  l.stiffness[0] = normal.stiffness;
  const double bound = c.friction * std::fmax(0.0, c.impulse[0]) * c.wt;
  const double g1 = c.impulse[1] * c.wt, g2 = c.impulse[2] * c.wt, x1 = g1 - c.u[1], x2 = g2 - c.u[2];
  const double size = std::sqrt(x1 * x1 + x2 * x2);
  if (size > 1e-14 * (std::fabs(g1) + std::fabs(g2)) && size > 0.0) {
    l.d1 = x1 / size;
    l.d2 = x2 / size;
  }
  const double g_along = g1 * l.d1 + g2 * l.d2, u_along = c.u[1] * l.d1 + c.u[2] * l.d2;
  const double g_across = g2 * l.d1 - g1 * l.d2, u_across = c.u[2] * l.d1 - c.u[1] * l.d2;
  const Slope slip = smoothed(bound - g_along, -u_along, std::fmin(tau, bound * bound), 1.0 / stiffest);
  l.offset[1] = -slip.offset;
  l.stiffness[1] = slip.stiffness;
  if (c.impulse[0] > 0.0) l.follows = slip.follows * c.friction;
  if (size > bound) {
    const double turn = bound / std::fmax(size - bound, 1e-300);
    l.stiffness[2] = std::fmin(stiffest, std::fmax(l.stiffness[1], turn));
    l.offset[2] = -g_across - l.stiffness[2] * u_across;
  } else {
    l.stiffness[2] = stiffest;
    l.offset[2] = -stiffest * u_across;
  }
  return l;
}

struct Newton {
  ContactIsland& island;
  std::vector<Linear> laws, used = {};
  std::vector<Mat3> stiffness = {};
  std::vector<BodyLoad> load = {}, change = {};

  /// With stiffnesses such that what is left [m/s] asks for no more than the impulses that there are: where rigid bodies hold each
  /// other in more ways than one, loads then move among them bit by bit.
  void linearise_all(double tau, double left) {
    double most = 0.0;
    for (const IslandContact& c : island.contacts) most = std::fmax(most, c.impulse[0] * c.wn);
    const double stiffest = std::clamp(most / left, least_stiffness, most_stiffness);
    for (std::size_t k = 0; k < laws.size(); k++) laws[k] = linearise(island.contacts[k], tau, stiffest);
  }
  bool changed(const Linear& now, const Linear& then) const {
    for (int j = 0; j < 3; j++) {
      const double a = now.stiffness[j], b = then.stiffness[j];
      if (std::fabs(a - b) > 0.02 * std::fmax(a, b) + 1e-4) return true;
    }
    if (std::fabs(now.follows - then.follows) > 0.02) return true;
    const bool turns = std::fabs(now.stiffness[1] - now.stiffness[2]) > 1e-3 * now.stiffness[2];
    return turns && std::fabs(now.d1 * then.d2 - now.d2 * then.d1) > 1e-3;
  }
  bool factor_serves() const {
    if (used.size() != laws.size()) return false;
    for (std::size_t k = 0; k < laws.size(); k++)
      if (changed(laws[k], used[k])) return false;
    return true;
  }
  void factorise_law() {
    used = laws;
    stiffness.assign(laws.size(), zero33());
    for (std::size_t k = 0; k < laws.size(); k++) {
      const IslandContact& c = island.contacts[k];
      if (used[k].stiffness[0] < 1e-12) {
        used[k].stiffness = zero3();
        continue;
      }
      const Vec3 along = c.frame[1] * used[k].d1 + c.frame[2] * used[k].d2,
                 across = c.frame[2] * used[k].d1 - c.frame[1] * used[k].d2;
      stiffness[k] = outer(c.frame[0], c.frame[0]) * (used[k].stiffness[0] / c.wn);
      if (c.friction == 0.0) continue;
      stiffness[k] += outer(along, c.frame[0]) * (used[k].follows * used[k].stiffness[0] / c.wn);
      stiffness[k] += outer(along, along) * (used[k].stiffness[1] / c.wt);
      stiffness[k] += outer(across, across) * (used[k].stiffness[2] / c.wt);
    }
    factorise(island, stiffness);
  }
  void move_impulses() {
    for (std::size_t k = 0; k < laws.size(); k++) {
      IslandContact& c = island.contacts[k];
      const Linear& l = laws[k];
      c.impulse[0] += l.offset[0] / c.wn;
      if (used[k].stiffness[0] == 0.0 || c.friction == 0.0) {
        c.impulse[1] = c.impulse[2] = 0.0;
        continue;
      }
      const double along = l.offset[1] / c.wt + used[k].follows * l.offset[0] / c.wn, across = l.offset[2] / c.wt;
      c.impulse[1] += along * l.d1 - across * l.d2;
      c.impulse[2] += along * l.d2 + across * l.d1;
    }
    for (IslandTie& t : island.ties) t.impulse -= t.u * (tie_stiffness / t.w);
  }
  void follow_velocities() {
    for (std::size_t i = 0; i < island.bodies.size(); i++) {
      IslandBody& b = island.bodies[i];
      b.dv = change[i].force;
      b.dw = change[i].moment;
      b.v += b.dv;
      b.w += b.dw;
    }
    for (std::size_t k = 0; k < laws.size(); k++) {
      IslandContact& c = island.contacts[k];
      const Vec3 du = to_frame(c, relative(c, island.bodies, &IslandBody::dv, &IslandBody::dw));
      const Linear& l = used[k];
      double along = 0.0, across = 0.0;
      if (c.friction > 0.0) {
        along = (du[1] * l.d1 + du[2] * l.d2) * l.stiffness[1] / c.wt + l.follows * du[0] * l.stiffness[0] / c.wn;
        across = (du[2] * l.d1 - du[1] * l.d2) * l.stiffness[2] / c.wt;
      }
      c.impulse -= vec(du[0] * l.stiffness[0] / c.wn, along * l.d1 - across * l.d2, along * l.d2 + across * l.d1);
    }
    for (IslandTie& t : island.ties) {
      const Vec3 du = velocity_of(t, island.bodies, &IslandBody::dv, &IslandBody::dw);
      t.impulse -= du * (tie_stiffness / t.w);
    }
  }
};

/// What to come back to.
struct Best {
  double residual = infinity;
  std::vector<Vec3> contacts, ties;
  void keep(const ContactIsland& island, double now) {
    residual = now;
    contacts.clear();
    ties.clear();
    for (const IslandContact& c : island.contacts) contacts.push_back(c.impulse);
    for (const IslandTie& t : island.ties) ties.push_back(t.impulse);
  }
  void put_back(ContactIsland& island) const {
    for (std::size_t k = 0; k < contacts.size(); k++) island.contacts[k].impulse = contacts[k];
    for (std::size_t k = 0; k < ties.size(); k++) island.ties[k].impulse = ties[k];
    apply_impulses(island);
    observe(island);
  }
};

}  // namespace

void unbalanced(const ContactIsland& island, std::vector<BodyLoad>& load) {
  load.resize(island.bodies.size());
  for (std::size_t i = 0; i < load.size(); i++) {
    const IslandBody& b = island.bodies[i];
    load[i] = {(b.v0 - b.v) * b.mass, b.inertia * (b.w0 - b.w)};
  }
  add_contact_loads(island, load);
  add_tie_loads(island, load);
}

SearchReport newton_search(ContactIsland& island, std::uint32_t most_iterations) {
  SearchReport report;
  Newton newton{island, std::vector<Linear>(island.contacts.size())};
  apply_impulses(island);
  observe(island);
  double now = residual(island);
  Best best;
  best.keep(island, now);
  if (now <= island.tolerance) {
    report.residual = now;
    return report;
  }
  set_base(island, tie_stiffness);
  const double smallest = 1e-4 * island.tolerance * island.tolerance;
  double tau = smoothing * smoothing * now * now;
  while (report.iterations < most_iterations && now > island.tolerance) {
    report.iterations++;
    newton.linearise_all(tau, now);
    if (!newton.factor_serves()) {
      newton.factorise_law();
      report.factorisations++;
    }
    newton.move_impulses();
    unbalanced(island, newton.load);
    newton.change.resize(newton.load.size());
    solve(island, newton.load, newton.change);
    newton.follow_velocities();
    apply_impulses(island);  // a stiff law makes much of the round-off of velocities
    observe(island);
    const double before = now;
    now = residual(island);
    if (!std::isfinite(now)) break;
    if (now < best.residual) best.keep(island, now);
    if (best.residual <= 10.0 * island.tolerance && now > 0.5 * before) break;
    tau = std::fmin(0.1 * tau, smoothing * smoothing * now * now);
    if (tau < smallest) tau = 0.0;
  }
  if (!(now <= best.residual)) best.put_back(island);
  report.residual = best.residual;
  return report;
}

}  // namespace pantin
