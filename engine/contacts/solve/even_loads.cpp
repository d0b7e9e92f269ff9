// The limit of bodies that give way a little, all contacts alike: (M + Σ G' k/w G) dv = Σ J' γ - M (v - v0), from γ = 0, and
// again from what that gives. Contacts that slide have their friction along; those that open leave the others.
#include "contacts/solve/even_loads.hpp"

#include <algorithm>
#include <cmath>

#include "contacts/solve/best_impulses.hpp"
#include "contacts/solve/matrix.hpp"
#include "contacts/solve/search.hpp"
#include "contacts/solve/solve.hpp"
#include "contacts/solve/ties.hpp"

namespace pantin {

namespace {

/// How a contact bears: not at all, held on all sides, or with friction along d1 t1 + d2 t2 of what it bears.
struct Bearing {
  bool bears = false, slides = false;
  double d1 = 0.0, d2 = 0.0;
};

/// With friction along x t1 + y t2.
Bearing sliding(const IslandContact& c, double x, double y) {
  const double t = std::hypot(x, y), part = t > 0.0 ? c.friction / t : 0.0;
  return {true, true, x * part, y * part};
}

Bearing bearing_of(const IslandContact& c, double tolerance) {
  if (!(c.impulse[0] > 0.0)) return {};
  if (c.friction == 0.0 || std::hypot(c.u[1], c.u[2]) > 10.0 * tolerance) return sliding(c, -c.u[1], -c.u[2]);
  return {true};
}

struct Evening {
  ContactIsland& island;
  double stiffness = 1e4;  // of contacts, of 1 / w: that of ties is a thousand times as large
  std::vector<Bearing> bearings = {};
  std::vector<char> holds = {};  // scalars
  std::vector<BodyLoad> load = {}, change = {};

  void factorise_bearings() {
    std::vector<Mat3> contacts(island.contacts.size(), zero33()), rolls(island.rolls.size(), zero33());
    bool symmetric = true;
    for (std::size_t k = 0; k < contacts.size(); k++) {
      const IslandContact& c = island.contacts[k];
      const Bearing& b = bearings[k];
      if (!b.bears) continue;
      const Vec3 n = c.frame[0];
      contacts[k] = outer(n + c.frame[1] * b.d1 + c.frame[2] * b.d2, n) * (stiffness / c.wn);
      symmetric = symmetric && b.d1 == 0.0 && b.d2 == 0.0;
      if (!b.slides) contacts[k] += (identity33() - outer(n, n)) * (stiffness / c.wt);
    }
    std::vector<double> scalars;
    for (std::size_t k = 0; k < holds.size(); k++) scalars.push_back(stiffness_of_scalar(k));
    factorise(island, island.all, contacts, rolls, scalars, symmetric);
  }
  double stiffness_of_scalar(std::size_t scalar) const {
    const IslandScalar& s = island.scalars[scalar];
    return !holds[scalar] ? 0.0 : (s.is_bounded() ? stiffness : tie_stiffness) / s.w;
  }

  void forget_ties() {
    for (IslandTie& t : island.ties)
      if (t.softness == 0.0) t.impulse = zero3();
  }
  void forget_loads() {
    for (IslandContact& c : island.contacts) c.impulse = zero3();
    for (std::size_t k = 0; k < holds.size(); k++)
      if (holds[k]) island.scalars[k].impulse = 0.0;
  }
  /// Adds what velocities at contacts and ties ask for.
  void follow(Vec3 IslandBody::*v, Vec3 IslandBody::*w) {
    const bool all = v == &IslandBody::v;
    for (std::size_t k = 0; k < bearings.size(); k++) {
      IslandContact& c = island.contacts[k];
      const Bearing& b = bearings[k];
      if (!b.bears) continue;
      const Vec3 u = all ? c.u : to_frame(c, relative(c, island.bodies, v, w));
      const double n = -u[0] * stiffness / c.wn, by = b.slides ? 0.0 : -stiffness / c.wt;
      c.impulse += vec(n, b.slides ? b.d1 * n : u[1] * by, b.slides ? b.d2 * n : u[2] * by);
    }
    for (IslandTie& t : island.ties) t.impulse -= (all ? t.u : velocity_of(t, island.bodies, v, w)) * stiffness_of(t);
    for (std::size_t k = 0; k < holds.size(); k++) {
      IslandScalar& s = island.scalars[k];
      s.impulse -= (all ? s.u : velocity_of(island, s, v, w)) * stiffness_of_scalar(k);
    }
  }
  void step() {
    follow(&IslandBody::v, &IslandBody::w);
    unbalanced(island, load);
    change.resize(load.size());
    solve(island, island.all, load, change);
    for (std::size_t i = 0; i < island.bodies.size(); i++) {
      island.bodies[i].dv = change[i].force;
      island.bodies[i].dw = change[i].moment;
    }
    follow(&IslandBody::dv, &IslandBody::dw);
    apply_impulses(island);
    observe(island);
  }
  /// Makes friction go against slip; whether it did not.
  bool turns(Bearing& b, const IslandContact& c) const {
    constexpr double nothing = 1e-9;
    if (c.friction == 0.0 || std::hypot(c.u[1], c.u[2]) <= island.tolerance) return false;
    const Bearing now = sliding(c, -c.u[1], -c.u[2]);
    if (std::hypot(now.d1 - b.d1, now.d2 - b.d2) <= nothing * c.friction) return false;
    b = now;
    return true;
  }
  /// Those that would pull bear no more, those that slide the way their friction goes are held, those that are held by more than
  /// friction slide, against where they slide; whether there were any.
  bool is_changed() {
    bool any = false;
    for (std::size_t k = 0; k < bearings.size(); k++) {
      const IslandContact& c = island.contacts[k];
      Bearing& b = bearings[k];
      if (!b.bears) continue;
      const double t = std::hypot(c.impulse[1], c.impulse[2]);
      if (!(c.impulse[0] > 0.0))
        b = {};
      else if (b.slides && c.u[1] * b.d1 + c.u[2] * b.d2 > island.tolerance)
        b = {true};
      else if (!b.slides && t > c.friction * c.impulse[0])
        b = sliding(c, c.impulse[1], c.impulse[2]);
      else if (!b.slides || !turns(b, c))
        continue;
      any = true;
    }
    for (std::size_t k = 0; k < holds.size(); k++) {
      IslandScalar& s = island.scalars[k];
      if (!holds[k] || (s.impulse >= s.low && s.impulse <= s.high)) continue;
      s.impulse = std::clamp(s.impulse, s.low, s.high);
      holds[k] = 0;
      any = true;
    }
    return any;
  }
};

}  // namespace

bool has_even_loads(const ContactIsland& island) { return is_small(island) && is_even(island); }

void even_loads(ContactIsland& island) {
  constexpr int most_rounds = 6, most_steps = 4;
  constexpr int most_passes = 2;  // from no loads: the second knows what ties bear, which is to count for nothing
  constexpr double nothing = 1e-3;
  constexpr std::uint32_t most_of_newton = 4;
  const auto bears = [](const IslandContact& c) { return c.impulse[0] > 0.0; };
  if (std::count_if(island.contacts.begin(), island.contacts.end(), bears) < 2) return;
  BestImpulses found;
  found.keep(island, residual(island));
  Evening evening{island};
  for (const IslandContact& c : island.contacts) evening.bearings.push_back(bearing_of(c, island.tolerance));
  for (const IslandScalar& s : island.scalars) evening.holds.push_back(!s.is_at_bound());
  set_base(island, island.all);
  for (int round = 0;; round++) {
    evening.factorise_bearings();
    evening.forget_ties();
    for (int i = 0; i < most_passes; i++) {
      evening.forget_loads();
      evening.step();
    }
    for (int i = 0; i < most_steps && residual(island) > nothing * island.tolerance; i++) evening.step();
    if (!evening.is_changed() || round == most_rounds) break;
  }
  double now = residual(island);
  if (now > island.tolerance && std::isfinite(now)) now = newton_search(island, most_of_newton).residual;
  if (!(now <= std::fmax(found.residual, island.tolerance))) found.put_back(island);
}

}  // namespace pantin
