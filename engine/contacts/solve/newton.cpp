// 0 ≤ γ ⊥ s ≥ 0 as γ + s - √((γ - s)² + 4τ) = 0 with τ towards 0 (Fischer 1992; Kanzow 1996), of the normal impulse with the
// normal speed, and of the slack friction γ_n - |γ_t| with the speed of slip. Impulses count times w here, so that all are speeds.
#include <algorithm>
#include <cmath>

#include "contacts/solve/best_impulses.hpp"
#include "contacts/solve/search.hpp"
#include "contacts/solve/ties.hpp"

namespace pantin {

namespace {

constexpr double least_stiffness = 1e3, most_stiffness = 1e8;  // of contacts, of 1 / w
constexpr double smoothing = 0.1;                              // √τ of the residual
constexpr std::uint32_t most_patience = 10;                    // iterations in which it may not halve

/// dγ = offset - stiffness ds makes the smoothed law hold to first order.
struct Slope {
  double offset, stiffness;
  double by_bound = 0.0;  ///< by how much the root moves with g: of slip, with the bound
};

Slope smoothed(double g, double s, double tau, double softness) {
  const double x = g - s, r = std::sqrt(x * x + 4.0 * tau) + 1e-300, size = std::fabs(x);
  const double low = 4.0 * tau / (r * (r + size) + 1e-300), high = (r + size) / r;
  const double by_g = x > 0.0 ? low : high, by_s = x > 0.0 ? high : low;
  const double value = x > 0.0 ? 2.0 * s - r * low : 2.0 * g - r * low;
  const double slope = by_g + by_s * softness;
  return {-value / slope, by_s / slope, by_g / slope};
}

/// A law of slip to first order: along it, across it.
struct Slip {
  double along = 0.0, across = 0.0;  // offsets
  double along_stiffness = 0.0, across_stiffness = 0.0;
  double d1 = 1.0, d2 = 0.0;  // its direction by t1 and t2
  double by_bound = 0.0;      // change of the impulse along it by that of its bound
};

/// Of impulses g within a bound, velocities u, all as speeds.
Slip linearise_slip(double g1, double g2, double u1, double u2, double bound, double tau, double stiffest) {
  Slip l;
  const double x1 = g1 - u1, x2 = g2 - u2, size = std::sqrt(x1 * x1 + x2 * x2);
  if (size > 1e-14 * (std::fabs(g1) + std::fabs(g2)) && size > 0.0) {
    l.d1 = x1 / size;
    l.d2 = x2 / size;
  }
  const double g_along = g1 * l.d1 + g2 * l.d2, u_along = u1 * l.d1 + u2 * l.d2;
  const double g_across = g2 * l.d1 - g1 * l.d2, u_across = u2 * l.d1 - u1 * l.d2;
  const Slope slip = smoothed(bound - g_along, -u_along, std::fmin(tau, bound * bound), 1.0 / stiffest);
  l.along = -slip.offset;
  l.along_stiffness = slip.stiffness;
  l.by_bound = slip.by_bound;
  if (size > bound) {
    const double turn = bound / std::fmax(size - bound, 1e-300);
    l.across_stiffness = std::fmin(stiffest, std::fmax(l.along_stiffness, turn));
    l.across = -g_across - l.across_stiffness * u_across;
  } else {
    l.across_stiffness = stiffest;
    l.across = -stiffest * u_across;
  }
  return l;
}

/// A contact's law to first order: normal, along the slip, across it.
struct Linear {
  Vec3 offset = zero3(), stiffness = zero3();
  double d1 = 1.0, d2 = 0.0;  // the slip's direction by t1 and t2
  double by_bound = 0.0;      // change of the impulse along the slip by that of the normal one
};

/// Of a scalar's law, at the nearer of its bounds.
Slope linearise(const IslandScalar& s, double tau) {
  const double g = s.impulse * s.w, x = g - s.u, softness = 1.0 / tie_stiffness;
  if (!s.is_bounded()) return {-tie_stiffness * s.u, tie_stiffness};
  if (s.high == infinity || x - s.low * s.w < s.high * s.w - x) return smoothed(g - s.low * s.w, s.u, tau, softness);
  Slope at_high = smoothed(s.high * s.w - g, -s.u, tau, softness);
  at_high.offset *= -1.0;
  return at_high;
}

/// The same of friction against spins; that it follows the normal impulse is left to the next iteration.
struct LinearRoll {
  Slip spin, roll;
};

LinearRoll linearise(const ContactIsland& island, const IslandRoll& r, double tau, double stiffest) {
  const double most = std::fmax(0.0, island.contacts[r.contact].impulse[0]);
  return {linearise_slip(r.impulse[0] * r.wn, 0.0, r.u[0], 0.0, most * r.wn, tau, stiffest),
          linearise_slip(r.impulse[1] * r.wt, r.impulse[2] * r.wt, r.u[1], r.u[2], most * r.wt, tau, stiffest)};
}

/// An impulse [N s] in the contact's frame of offsets, or of changes of velocities.
Vec3 impulse_of(const IslandRoll& r, const LinearRoll& law, double spin, double along, double across) {
  const double n = r.wn > 0.0 ? spin / r.wn : 0.0, by = r.wt > 0.0 ? 1.0 / r.wt : 0.0;
  return vec(n, (along * law.roll.d1 - across * law.roll.d2) * by, (along * law.roll.d2 + across * law.roll.d1) * by);
}

Linear linearise(const IslandContact& c, double tau, double stiffest) {
  Linear l;
  const Slope normal =
      smoothed(c.impulse[0] * c.wn, c.u[0] + c.compliance * c.impulse[0], tau, 1.0 / stiffest + c.compliance / c.wn);
  const double bound = c.friction * std::fmax(0.0, c.impulse[0]) * c.wt;
  const Slip slip = linearise_slip(c.impulse[1] * c.wt, c.impulse[2] * c.wt, c.u[1], c.u[2], bound, tau, stiffest);
  l.offset = vec(normal.offset, slip.along, slip.across);
  l.stiffness = vec(normal.stiffness, slip.along_stiffness, slip.across_stiffness);
  l.d1 = slip.d1;
  l.d2 = slip.d2;
  if (c.impulse[0] > 0.0) l.by_bound = slip.by_bound * c.friction;
  return l;
}

struct Newton {
  ContactIsland& island;
  std::vector<Linear> laws, used = {};
  std::vector<LinearRoll> roll_laws = {}, roll_used = {};
  std::vector<Mat3> stiffness = {}, roll_stiffness = {};
  std::vector<Slope> scalar_laws = {}, scalars_used = {};
  std::vector<double> scalar_stiffness = {};
  std::vector<BodyLoad> load = {}, change = {};

  /// With stiffnesses such that what is left [m/s] asks for no more than the impulses that there are: where rigid bodies hold each
  /// other in more ways than one, loads then move among them bit by bit.
  void linearise_all(double tau, double left) {
    double most = 0.0;
    for (const IslandContact& c : island.contacts) most = std::fmax(most, c.impulse[0] * c.wn);
    const double stiffest = std::clamp(most / left, least_stiffness, most_stiffness);
    for (std::size_t k = 0; k < laws.size(); k++) laws[k] = linearise(island.contacts[k], tau, stiffest);
    roll_laws.clear();
    for (const IslandRoll& r : island.rolls) roll_laws.push_back(linearise(island, r, tau, stiffest));
    scalar_laws.clear();
    for (const IslandScalar& s : island.scalars) scalar_laws.push_back(linearise(s, tau));
  }
  static bool differs(double a, double b) { return std::fabs(a - b) > 0.02 * std::fmax(a, b) + 1e-4; }
  bool changed(const Slip& now, const Slip& then) const {
    return differs(now.along_stiffness, then.along_stiffness) || differs(now.across_stiffness, then.across_stiffness) ||
           std::fabs(now.d1 * then.d2 - now.d2 * then.d1) > 1e-3;
  }
  bool changed(const Linear& now, const Linear& then) const {
    for (int j = 0; j < 3; j++)
      if (differs(now.stiffness[j], then.stiffness[j])) return true;
    if (std::fabs(now.by_bound - then.by_bound) > 0.02) return true;
    const bool turns = std::fabs(now.stiffness[1] - now.stiffness[2]) > 1e-3 * now.stiffness[2];
    return turns && std::fabs(now.d1 * then.d2 - now.d2 * then.d1) > 1e-3;
  }
  bool factor_serves() const {
    if (used.size() != laws.size() || scalars_used.size() != scalar_laws.size()) return false;
    for (std::size_t k = 0; k < laws.size(); k++)
      if (changed(laws[k], used[k])) return false;
    for (std::size_t k = 0; k < roll_laws.size(); k++)
      if (changed(roll_laws[k].spin, roll_used[k].spin) || changed(roll_laws[k].roll, roll_used[k].roll)) return false;
    for (std::size_t k = 0; k < scalar_laws.size(); k++)
      if (differs(scalar_laws[k].stiffness, scalars_used[k].stiffness)) return false;
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
      stiffness[k] += outer(along, c.frame[0]) * (used[k].by_bound * used[k].stiffness[0] / c.wn);
      stiffness[k] += outer(along, along) * (used[k].stiffness[1] / c.wt);
      stiffness[k] += outer(across, across) * (used[k].stiffness[2] / c.wt);
    }
    roll_used = roll_laws;
    roll_stiffness.assign(roll_laws.size(), zero33());
    for (std::size_t k = 0; k < roll_laws.size(); k++) {
      const IslandRoll& r = island.rolls[k];
      if (used[r.contact].stiffness[0] == 0.0) {
        roll_used[k] = {};
        continue;
      }
      const Mat3& frame = island.contacts[r.contact].frame;
      const Slip& l = roll_used[k].roll;
      const Vec3 along = frame[1] * l.d1 + frame[2] * l.d2, across = frame[2] * l.d1 - frame[1] * l.d2;
      const double spin = r.lever[0] * r.lever[0], roll = r.lever[1] * r.lever[1];
      if (r.wn > 0.0)
        roll_stiffness[k] += outer(frame[0], frame[0]) * (spin * roll_used[k].spin.along_stiffness / r.wn);
      if (r.wt > 0.0)
        roll_stiffness[k] += outer(along, along) * (roll * l.along_stiffness / r.wt) +
                             outer(across, across) * (roll * l.across_stiffness / r.wt);
    }
    scalars_used = scalar_laws;
    scalar_stiffness.clear();
    for (std::size_t k = 0; k < scalars_used.size(); k++) {
      if (scalars_used[k].stiffness < 1e-12) scalars_used[k].stiffness = 0.0;
      scalar_stiffness.push_back(scalars_used[k].stiffness / island.scalars[k].w);
    }
    const bool symmetric = std::none_of(used.begin(), used.end(), [](const Linear& l) { return l.by_bound != 0.0; });
    factorise(island, island.all, stiffness, roll_stiffness, scalar_stiffness, symmetric);
  }
  void move_rolls() {
    for (std::size_t k = 0; k < roll_laws.size(); k++) {
      IslandRoll& r = island.rolls[k];
      const LinearRoll& l = roll_laws[k];
      if (used[r.contact].stiffness[0] == 0.0)
        r.impulse = zero3();
      else
        r.impulse += impulse_of(r, l, l.spin.along * l.spin.d1, l.roll.along, l.roll.across);
    }
  }
  void follow_spins() {
    for (std::size_t k = 0; k < roll_laws.size(); k++) {
      IslandRoll& r = island.rolls[k];
      const Vec3 du = velocity_of(island, r, &IslandBody::dw);
      const LinearRoll& l = roll_used[k];
      const double along = (du[1] * l.roll.d1 + du[2] * l.roll.d2) * l.roll.along_stiffness,
                   across = (du[2] * l.roll.d1 - du[1] * l.roll.d2) * l.roll.across_stiffness;
      r.impulse -= impulse_of(r, l, du[0] * l.spin.along_stiffness, along, across);
    }
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
      const double along = l.offset[1] / c.wt + used[k].by_bound * l.offset[0] / c.wn, across = l.offset[2] / c.wt;
      c.impulse[1] += along * l.d1 - across * l.d2;
      c.impulse[2] += along * l.d2 + across * l.d1;
    }
    move_rolls();
    for (IslandTie& t : island.ties) t.impulse -= t.u * stiffness_of(t);
    for (std::size_t k = 0; k < scalar_laws.size(); k++)
      island.scalars[k].impulse += scalar_laws[k].offset / island.scalars[k].w;
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
        along = (du[1] * l.d1 + du[2] * l.d2) * l.stiffness[1] / c.wt + l.by_bound * du[0] * l.stiffness[0] / c.wn;
        across = (du[2] * l.d1 - du[1] * l.d2) * l.stiffness[2] / c.wt;
      }
      c.impulse -= vec(du[0] * l.stiffness[0] / c.wn, along * l.d1 - across * l.d2, along * l.d2 + across * l.d1);
    }
    follow_spins();
    for (IslandTie& t : island.ties) {
      const Vec3 du = velocity_of(t, island.bodies, &IslandBody::dv, &IslandBody::dw);
      t.impulse -= du * stiffness_of(t);
    }
    for (std::size_t k = 0; k < scalars_used.size(); k++) {
      IslandScalar& s = island.scalars[k];
      s.impulse -= velocity_of(island, s, &IslandBody::dv, &IslandBody::dw) * scalars_used[k].stiffness / s.w;
    }
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
  BestImpulses best;
  best.keep(island, now);
  if (now <= island.tolerance) {
    report.residual = now;
    return report;
  }
  set_base(island, island.all);
  const double smallest = 1e-4 * island.tolerance * island.tolerance;
  double tau = smoothing * smoothing * now * now;
  Patience patience{most_patience, now};
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
    solve(island, island.all, newton.load, newton.change);
    newton.follow_velocities();
    apply_impulses(island);  // a stiff law makes much of the round-off of velocities
    observe(island);
    const double before = now;
    now = residual(island);
    if (!std::isfinite(now)) break;
    if (now < best.residual) best.keep(island, now);
    if (patience.ends(now)) break;
    if (best.residual <= 10.0 * island.tolerance && now > 0.5 * before) break;
    tau = std::fmin(0.1 * tau, smoothing * smoothing * now * now);
    if (tau < smallest) tau = 0.0;
  }
  if (!(now <= best.residual)) best.put_back(island);
  report.residual = best.residual;
  return report;
}

}  // namespace pantin
