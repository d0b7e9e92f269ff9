// A connection solved with its articulate, so that no stiffness limits the step. The force is f = -Q e, e = d0 + d1.
// Of a law with an energy V(s), s = d², Q = ΔV/Δs: f·Δd = -ΔV exactly (discrete gradient; Gonzalez 1996), for a small Δs
// by Gauss' rule. Without an energy, Q = tension/(|d0| + |d1|) with its mean on the way, by the same rule, at the mean
// rate u = Δr/h: f·Δd = -tension Δr, of a damper -c h u², which never gives.
//   With these alone what is damped would swing to and fro where the step is too long to follow it. So it has more
// damping, by which its length settles about as fast as in truth, at most that of the backward rule, h k/2. And at the
// end of the full sub-step the rate of its distance is drawn to u by an impulse -m_s (rate - u). That gives m_s u²/4 at most,
// and m_s <= 4 c h: spring, damper and impulse together only take energy. Both are small, of third order in h, where
// ζ = h c μ and ν² = h² k μ are, μ the row's mobility.
// Newton's row is M (change of d1) + C df = -residual with M = Σ Q 1 + e ∇Q', C = 1, all divided by what makes it metres.
#include "constraints/stiff.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace pantin {

namespace {

constexpr std::array<double, 4> positions = {0.06943184420297371, 0.33000947820757187, 0.66999052179242813,
                                             0.93056815579702629};
constexpr std::array<double, 4> weights = {0.17392742256872693, 0.32607257743127307, 0.32607257743127307,
                                           0.17392742256872693};

/// Q with its derivative along d1: ∇Q = slope d1.
struct Pull {
  double Q = 0.0, slope = 0.0;
};

Pull of_energy(PairCurve& curve, double s0, double s1, double energy0) {
  const double change = s1 - s0;
  std::array<double, 5> s;
  for (std::size_t i = 0; i < 4; i++) s[i] = s0 + change * positions[i];
  s[4] = s1;
  curve.run(5, s.data(), 0.0);
  const PairCurve::Value end = curve.at(4);
  if (std::fabs(change) > 2e-3 * std::fmax(s0, s1)) {
    const double Q = (end.energy - energy0) / change;
    return {Q, (end.pull - 2.0 * Q) / change};
  }
  Pull p;
  for (std::size_t i = 0; i < 4; i++) {
    const PairCurve::Value v = curve.at(static_cast<int>(i));
    p.Q += 0.5 * weights[i] * v.pull;
    p.slope += weights[i] * positions[i] * v.by_distance2;
  }
  return p;
}

/// The mean tension on the way, at the mean rate.
Pull of_tension(PairCurve& curve, double r0, double r1, double rate, double h) {
  std::array<double, 4> r, s;
  for (std::size_t i = 0; i < 4; i++) {
    r[i] = r0 + (r1 - r0) * positions[i];
    s[i] = r[i] * r[i];
  }
  curve.run(4, s.data(), rate);
  double tension = 0.0, by_end = 0.0;  // [N], [N/m]
  for (std::size_t i = 0; i < 4; i++) {
    const PairCurve::Value v = curve.at(static_cast<int>(i));
    const double by_distance = v.pull + r[i] * (2.0 * r[i] * v.by_distance2 + rate * v.by_approach);
    tension += weights[i] * v.pull * r[i];
    by_end += weights[i] * (by_distance * positions[i] + s[i] * v.by_approach / h);
  }
  const double both = r0 + r1, Q = tension / both;
  return {Q, (by_end - Q) / (both * r1)};
}

Pull of_damper(double damping, double r0, double r1, double h) {
  const double r = 0.5 * (r0 + r1), rate = (r1 - r0) / h;
  return {0.5 * damping * rate / r, 0.5 * damping * (1.0 / h - 0.5 * rate / r) / (r * r1)};
}

}  // namespace

void make_stiff(const Model& model, ConnectionId id, Row& row, Condition& condition) {
  const Connection& c = model.connections[id];
  const bool swapped = !c.particles[0];  // a position of the world is always the second end
  condition.stiff = std::make_shared<StiffBond>();
  StiffBond& bond = *condition.stiff;
  bond.connection = id;
  bond.a = c.particles[swapped ? 1 : 0];
  bond.b = c.particles[swapped ? 0 : 1];
  bond.solve = c.solve;
  if (!bond.b) condition.whole0 = condition.whole1 = model.plane.along(c.positions[swapped ? 0 : 1]);
  const Vec3 d = position(model, bond.a) - (bond.b ? position(model, bond.b) : condition.whole1);
  bond.least2 = 1e-24 * (norm2(d) > 0.0 ? norm2(d) : 1.0);
  for (auto law = c.law; law; law = law->also) bond.curves.emplace_back(*law);
  for (auto* column : {&bond.energy0, &bond.pulls, &condition.energy_given}) column->resize(bond.curves.size());
  row.f = direction(d) * -c.tension;
}

double add_energies(StiffBond& bond, Vec3 d, double times, std::vector<double>& list) {
  const double square = std::fmax(norm2(d), bond.least2);
  double all = 0.0;
  for (std::size_t i = 0; i < bond.curves.size(); i++) {
    if (!bond.curves[i].has_energy()) continue;
    bond.curves[i].run(1, &square, 0.0);
    all += bond.curves[i].at(0).energy;
    list[i] += times * bond.curves[i].at(0).energy;
  }
  return all;
}

void start_stiff(StiffBond& bond, const Row& row, double approach) {
  const double s0 = std::fmax(norm2(row.d0), bond.least2);
  bond.rate0 = approach / std::sqrt(s0);
  bond.damping_known = false;
  for (std::size_t i = 0; i < bond.curves.size(); i++) {
    bond.energy0[i] = 0.0;
    if (!bond.curves[i].has_energy()) continue;
    bond.curves[i].run(1, &s0, 0.0);
    bond.energy0[i] = bond.curves[i].at(0).energy;
  }
}

namespace {

/// How its length draws back, where it does.
struct DrawingBack {
  double k = 0.0, c = 0.0;  // [N/m], [N s/m] of its curves
  double pull = 0.0;        // [N/m] of them, for its length
  double damping = 0.0;     // [N s/m] beyond that, in the step
};

DrawingBack drawing_back(StiffBond& bond, double s, double rate, const RowContext& context) {
  DrawingBack by;
  for (PairCurve& curve : bond.curves) {
    curve.run(1, &s, rate);
    const PairCurve::Value v = curve.at(0);
    if (curve.depends_on_velocity()) by.c += s * v.by_approach;
    by.k += v.pull + 2.0 * s * v.by_distance2;
    by.pull += v.pull;
  }
  by.c = std::fmax(by.c, 0.0);
  by.k = std::fmax(by.k, 0.0);
  const bool at_end = bond.solve == Solve::at_end;
  if (!at_end && by.c == 0.0) return by;
  const double h = context.h, nu2 = h * h * by.k * context.mobility, zeta = h * by.c * context.mobility;
  const double part = at_end ? 1.0 : nu2 * zeta / (nu2 * zeta + 4.0 * nu2 + 6.0 * zeta * zeta);
  by.damping = 0.5 * h * by.k * part;
  return by;
}

/// Finds how it is to settle in the step, by its stiffness and damping at the start.
void choose_damping(StiffBond& bond, double s0, const RowContext& context) {
  const DrawingBack by = drawing_back(bond, s0, bond.rate0, context);
  bond.damping_known = true;
  bond.damping = by.damping;
  const double h = context.h, mu = context.mobility, zeta = h * by.c * mu;
  const double fast = zeta * zeta + 0.25 * h * h * by.k * mu;
  bond.settling = bond.solve == Solve::at_end ? 0.5 * h * (by.c + by.damping) : 0.5 * h * by.c * fast / (1.0 + fast);
}

}  // namespace

DrawnInStep drawn_in_step(StiffBond& bond, Vec3 d, const RowContext& context) {
  const DrawingBack by = drawing_back(bond, std::fmax(norm2(d), bond.least2), 0.0, context);
  const double half = 0.5 * context.h;
  return {half * (half * by.k + by.c + by.damping), half * half * std::fmax(by.pull, 0.0)};
}

StiffPull pull_at(StiffBond& bond, Vec3 d) {
  StiffPull p;
  const double s = std::fmax(norm2(d), bond.least2);
  const Mat3 along = outer(d, d);
  for (PairCurve& curve : bond.curves) {
    curve.run(1, &s, 0.0);
    const PairCurve::Value v = curve.at(0);
    p.f -= d * v.pull;
    p.by_position -= identity33() * std::fmax(0.0, v.pull) + along * std::fmax(0.0, 2.0 * v.by_distance2);
    p.by_rate -= along * std::fmax(0.0, v.by_approach);
  }
  return p;
}

double StiffBond::first_length() const { return 1e12 * std::sqrt(least2); }

bool StiffBond::is_nonconservative() const {
  return solve == Solve::at_end ||
         std::any_of(curves.begin(), curves.end(), [](const PairCurve& curve) { return !curve.has_energy(); });
}

bool StiffBond::is_damped() const {
  return solve == Solve::at_end ||
         std::any_of(curves.begin(), curves.end(), [](const PairCurve& curve) { return curve.depends_on_velocity(); });
}

double StiffBond::take_work(const Row& row, std::vector<double>& energy_given) {
  const Vec3 e = row.d0 + row.d1, displacement = row.d1 - row.d0;
  const double least = std::sqrt(least2), r0 = std::fmax(norm(row.d0), least), r1 = std::fmax(norm(row.d1), least);
  double damped = damping * mean_rate * (r1 - r0);  // [J] that dampers took
  double nonconservative = -damped;
  double unexplained = dot(row.f, displacement) + damped;  // [J] what no curve gives: told as the first one's
  for (std::size_t i = 0; i < curves.size(); i++) {
    const double work = -pulls[i] * dot(e, displacement);
    unexplained -= work;
    (curves[i].has_energy() ? energy_given[i] : nonconservative) += work;
    if (!curves[i].depends_on_velocity()) continue;
    damped -= work + of_tension(curves[i], r0, r1, 0.0, infinity).Q * dot(e, displacement);
  }
  energy_given[0] += unexplained;
  const double most = 4.0 * std::fmax(damped, 0.0), rate2 = mean_rate * mean_rate;
  if (settling * rate2 > most) settling = most / rate2;
  return nonconservative;
}

namespace {

double evaluate_stiff(Row& row, Condition& c, const RowContext& context) {
  StiffBond& bond = *c.stiff;
  const double s0 = std::fmax(norm2(row.d0), bond.least2), s1 = std::fmax(norm2(row.d1), bond.least2);
  const double r0 = std::sqrt(s0), r1 = std::sqrt(s1), h = context.h;
  if (!bond.damping_known) choose_damping(bond, s0, context);
  const Vec3 e = row.d0 + row.d1;
  Vec3 missed = row.f;
  double Q = 0.0, slope = 0.0, sizes = 0.0, stiffness = 0.0;
  const auto add = [&](Pull p) {
    missed += e * p.Q;
    Q += p.Q;
    slope += p.slope;
    sizes += std::fabs(p.Q) * norm(e);
    stiffness += std::fabs(p.slope) * norm(e) * r1;
  };
  for (std::size_t i = 0; i < bond.curves.size(); i++) {
    PairCurve& curve = bond.curves[i];
    const Pull p =
        curve.has_energy() ? of_energy(curve, s0, s1, bond.energy0[i]) : of_tension(curve, r0, r1, (r1 - r0) / h, h);
    add(p);
    bond.pulls[i] = p.Q;
  }
  if (bond.damping > 0.0) add(of_damper(bond.damping, r0, r1, h));
  bond.mean_rate = (r1 - r0) / h;
  stiffness += std::fabs(Q);
  const Vec3 displacement = row.d1 - row.d0;
  const double to_metres = 1.0 / (stiffness + 2.0 / (h * h * context.mobility));
  row.residual = missed * to_metres;
  c.M = (identity33() * Q + outer(e * slope, row.d1)) * to_metres;
  c.C = identity33() * to_metres;
  // What is missed does work that no energy knows of: it counts as the gap that would do as much.
  const double least = 2e-3 * norm(displacement) / (h * h * context.mobility);
  const double work = std::fabs(dot(missed, displacement));
  const double force = bond.settling > 0.0 ? sizes : norm(row.f);  // what is in balance rounds as each part does
  // What is missed across the connection, where it is not stiff, moves it much further; it counts for a part of that, since
  // its length hardly changes with it.
  const Vec3 u = direction(e);
  const double across = norm(missed - u * dot(missed, u)) / (std::fabs(Q) + 2.0 / (h * h * context.mobility));
  const double size = std::fmax(norm(row.residual), 0.01 * across);
  return std::fmax(size, work > 0.0 ? work / std::fmax(force, least) : 0.0);
}

void project_stiff(const Row& row, Condition& c, bool) {
  const Vec3 n = c.settles ? direction(row.d1) : zero3();
  c.kept = outer(n, n);
  c.wanted += n * c.mean_rate;
}

}  // namespace

const RowRule stiff_row = {.soft = true, .by_law = true, .evaluate = evaluate_stiff, .project = project_stiff};

void hold_length(Row& row, Condition& c) {
  c.kept_value = norm(row.d0);
  c.accepted = 0.0;
  row.offset = zero3();
  row.rule = norm2(row.d0) > c.stiff->least2 ? &rod_row : &rigid_row;
}

void pull_again(Row& row) { row.rule = &stiff_row; }

}  // namespace pantin
