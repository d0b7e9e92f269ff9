// A connection solved with its articulate, so that no stiffness limits the step. The force is f = -Q e.
//   middle: e = d0 + d1. Of a law with an energy V(s), s = d², Q = ΔV/Δs: f·Δd = -ΔV exactly (discrete gradient;
//     Gonzalez 1996), for a small Δs by Gauss' rule. Without an energy, 2 Q = tension/distance at the mean distance and
//     rate: f·Δd = -tension Δr.
//   end: e = d1, Q = tension/distance at the end of the step, with the rate there, 2 Δr/h less that at its start. A damper
//     that is too strong for the step, with h c / m above 1, the middle would turn round: it and what acts with it have the
//     tension of the end along d0 + d1, which keeps the angular momentum.
// Newton's row is M (change of d1) + C df = -residual with M = Σ Q 1 + e ∇Q', C = 1, all divided by what makes it metres.
#include "articulates/stiff.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace pantin {

namespace {

constexpr std::array<double, 4> places = {0.06943184420297371, 0.33000947820757187, 0.66999052179242813,
                                          0.93056815579702629};
constexpr std::array<double, 4> weights = {0.17392742256872693, 0.32607257743127307, 0.32607257743127307,
                                           0.17392742256872693};

/// Q with its derivative along d1: ∇Q = slope d1.
struct Pull {
  double Q = 0.0, slope = 0.0;
};

Pull of_energy(PairCurve& curve, double s0, double s1, double energy0, double& energy1) {
  const double change = s1 - s0;
  std::array<double, 5> s;
  for (std::size_t i = 0; i < 4; i++) s[i] = s0 + change * places[i];
  s[4] = s1;
  curve.run(5, s.data(), 0.0);
  const PairCurve::Value end = curve.at(4);
  energy1 = end.energy;
  if (std::fabs(change) > 2e-3 * std::fmax(s0, s1)) {
    const double Q = (energy1 - energy0) / change;
    return {Q, (end.pull - 2.0 * Q) / change};
  }
  Pull p;
  for (std::size_t i = 0; i < 4; i++) {
    const PairCurve::Value v = curve.at(static_cast<int>(i));
    p.Q += 0.5 * weights[i] * v.pull;
    p.slope += weights[i] * places[i] * v.by_distance2;
  }
  return p;
}

Pull at_mean(PairCurve& curve, double r0, double r1, double h) {
  const double r = 0.5 * (r0 + r1), rate = (r1 - r0) / h, s = r * r;
  curve.run(1, &s, r * rate);
  const PairCurve::Value v = curve.at(0);
  return {0.5 * v.pull, 0.5 * (v.by_distance2 * r + v.by_approach * (0.5 * rate + r / h)) / r1};
}

Pull at_end(PairCurve& curve, double r0, double r1, double rate0, double h, double& energy1) {
  const double rate = 2.0 * (r1 - r0) / h - rate0, s = r1 * r1;
  curve.run(1, &s, r1 * rate);
  const PairCurve::Value v = curve.at(0);
  energy1 = v.energy;
  return {v.pull, (2.0 * v.by_distance2 * r1 + v.by_approach * (rate + 2.0 * r1 / h)) / r1};
}

}  // namespace

void make_stiff(const Model& model, ConnectionId id, Row& row, Condition& condition) {
  const Connection& c = model.connections[id];
  const bool swapped = !c.particles[0];  // a place of the world is always the second end
  condition.stiff = std::make_shared<StiffTie>();
  StiffTie& tie = *condition.stiff;
  tie.connection = id;
  tie.a = c.particles[swapped ? 1 : 0];
  tie.b = c.particles[swapped ? 0 : 1];
  tie.solve = c.solve;
  if (!tie.b) condition.whole0 = condition.whole1 = model.plane.along(c.places[swapped ? 0 : 1]);
  const Vec3 d = position(model, tie.a) - (tie.b ? position(model, tie.b) : condition.whole1);
  tie.least2 = 1e-24 * (norm2(d) > 0.0 ? norm2(d) : 1.0);
  for (auto law = c.law; law; law = law->also) tie.curves.emplace_back(*law);
  for (auto* column : {&tie.energy0, &tie.energy1, &tie.pulls, &condition.given}) column->resize(tie.curves.size());
  row.f = direction(d) * -c.tension;
}

void start_stiff(StiffTie& tie, const Row& row, double approach) {
  const double s0 = std::fmax(norm2(row.d0), tie.least2);
  tie.rate0 = approach / std::sqrt(s0);
  tie.chosen = false;
  for (std::size_t i = 0; i < tie.curves.size(); i++) {
    tie.energy0[i] = tie.energy1[i] = 0.0;
    if (!tie.curves[i].has_energy()) continue;
    tie.curves[i].run(1, &s0, 0.0);
    tie.energy0[i] = tie.energy1[i] = tie.curves[i].at(0).energy;
  }
}

namespace {

/// Whether a damper is too strong for the middle of the step.
bool is_strong(StiffTie& tie, double s0, const RowContext& context) {
  tie.chosen = true;
  double damping = 0.0;  // [N s/m]
  for (PairCurve& curve : tie.curves) {
    if (curve.has_energy() || !curve.is_moving()) continue;
    curve.run(1, &s0, std::sqrt(s0) * tie.rate0);
    damping += s0 * curve.at(0).by_approach;
  }
  return std::fabs(context.h) * damping * context.mobility > 1.0;
}

/// The same force along the mean of both distances, where it turns nothing.
Pull along_mean(Pull p, const Row& row, double r1) {
  const Vec3 e = row.d0 + row.d1;
  const double length = std::fmax(norm(e), 1e-12 * r1), cosine = dot(e, row.d1) / (length * r1);
  return {p.Q * r1 / length, (p.slope * r1 * r1 / length + p.Q / length - p.Q * r1 * cosine / (length * length)) / r1};
}

}  // namespace

double evaluate_stiff(Row& row, Condition& c, const RowContext& context) {
  StiffTie& tie = *c.stiff;
  const double s0 = std::fmax(norm2(row.d0), tie.least2), s1 = std::fmax(norm2(row.d1), tie.least2);
  const double r0 = std::sqrt(s0), r1 = std::sqrt(s1);
  if (!tie.chosen) tie.strong = tie.solve == Solve::at_middle && is_strong(tie, s0, context);
  Vec3 missed = row.f, bent = zero3();
  double Q = 0.0, stiffness = 0.0, sizes = 0.0;
  for (std::size_t i = 0; i < tie.curves.size(); i++) {
    PairCurve& curve = tie.curves[i];
    const bool ends = tie.strong || tie.solve == Solve::at_end;
    Pull p = ends                 ? at_end(curve, r0, r1, tie.rate0, context.h, tie.energy1[i])
             : curve.has_energy() ? of_energy(curve, s0, s1, tie.energy0[i], tie.energy1[i])
                                  : at_mean(curve, r0, r1, context.h);
    if (tie.strong) p = along_mean(p, row, r1);
    const Vec3 e = tie.arm(row);
    missed += e * p.Q;
    bent += e * p.slope;
    Q += p.Q;
    sizes += std::fabs(p.Q) * norm(e);
    stiffness += std::fabs(p.slope) * norm(e) * r1;
    tie.pulls[i] = p.Q;
  }
  stiffness += std::fabs(Q);
  const Vec3 way = row.d1 - row.d0;
  const double weight = 1.0 / (stiffness + 2.0 / (context.h * context.h * context.mobility));
  row.residual = missed * weight;
  c.M = (identity33() * Q + outer(bent, row.d1)) * weight;
  c.C = identity33() * weight;
  // What is missed does work that no energy knows of: it counts as the gap that would do as much.
  const double least = 2e-3 * norm(way) / (context.h * context.h * context.mobility);
  const double work = std::fabs(dot(missed, way));
  const double force =
      tie.strong ? sizes : norm(row.f);  // a damper and a spring that are in balance round as each does
  return std::fmax(norm(row.residual), work > 0.0 ? work / std::fmax(force, least) : 0.0);
}

StiffPull pull_at(StiffTie& tie, Vec3 d) {
  StiffPull p;
  const double s = std::fmax(norm2(d), tie.least2);
  const Mat3 along = outer(d, d);
  for (PairCurve& curve : tie.curves) {
    curve.run(1, &s, 0.0);
    const PairCurve::Value v = curve.at(0);
    p.f -= d * v.pull;
    p.by_place -= identity33() * std::fmax(0.0, v.pull) + along * std::fmax(0.0, 2.0 * v.by_distance2);
    p.by_rate -= along * std::fmax(0.0, v.by_approach);
  }
  return p;
}

bool StiffTie::is_open() const {
  return solve == Solve::at_end ||
         std::any_of(curves.begin(), curves.end(), [](const PairCurve& curve) { return !curve.has_energy(); });
}

bool StiffTie::is_damped() const {
  return solve == Solve::at_end ||
         std::any_of(curves.begin(), curves.end(), [](const PairCurve& curve) { return curve.is_moving(); });
}

double StiffTie::settle(const Row& row, std::vector<double>& given) const {
  const Vec3 way = row.d1 - row.d0;
  double open = 0.0, rest = dot(row.f, way);
  for (std::size_t i = 0; i < curves.size(); i++) {
    const double work = -pulls[i] * dot(arm(row), way), rise = energy1[i] - energy0[i];
    rest -= work;
    const bool exact = solve == Solve::at_middle && !strong;
    const double from_energy = !curves[i].has_energy() ? 0.0 : exact ? work : -rise;
    given[i] += from_energy;
    open += work - from_energy;
  }
  given[0] += rest;
  return open;
}

}  // namespace pantin
