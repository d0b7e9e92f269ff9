#include "contacts/solve/solve.hpp"

#include <algorithm>
#include <cmath>

#include "contacts/solve/even_loads.hpp"
#include "contacts/solve/search.hpp"
#include "contacts/solve/ties.hpp"

namespace pantin {
namespace {

constexpr std::uint32_t most_of_newton = 30;
constexpr std::uint32_t most_sweeps = 10, more_sweeps = 40, sweeps_before_newton = 30;
constexpr std::uint32_t rounds_of_hard = 4, sweeps_of_hard = 100, newton_of_hard = 30;  // where a small island is hard
constexpr std::size_t many = 1000;            // contacts: a factorisation of such an island costs as much as 20 sweeps
constexpr std::uint32_t sweeps_of_many = 60;  // more, where it is calm
constexpr double very_calm = 0.1;             // of the speed of a calm island: one of many is solved exactly
constexpr std::uint32_t most_rounds = 8;      // of proximal steps
constexpr double accepted = 100.0;            // of the tolerance
constexpr double deep = 2.5e8;                // of the tolerance: a hundredth of the thickness in a drift
constexpr std::size_t most_updates = 100;     // of blocks in a factorisation, for each contact
constexpr std::size_t most_of_memory = 200'000'000;  // of them at all: 4 bytes each

/// Puts impulses into the cone.
void confine(ContactIsland& island) {
  for (IslandContact& c : island.contacts) {
    if (!(c.impulse[0] > 0.0)) {
      c.impulse = zero3();
      continue;
    }
    const double t = std::sqrt(c.impulse[1] * c.impulse[1] + c.impulse[2] * c.impulse[2]),
                 bound = c.friction * c.impulse[0];
    if (t <= bound) continue;
    c.impulse[1] *= bound / t;
    c.impulse[2] *= bound / t;
  }
  for (IslandRoll& r : island.rolls) {
    const double most = island.contacts[r.contact].impulse[0];
    const double t = std::sqrt(r.impulse[1] * r.impulse[1] + r.impulse[2] * r.impulse[2]);
    r.impulse[0] = std::clamp(r.impulse[0], -most, most);
    if (t <= most) continue;
    r.impulse[1] *= most / t;
    r.impulse[2] *= most / t;
  }
  for (IslandScalar& s : island.scalars) s.impulse = std::clamp(s.impulse, s.low, s.high);
}

struct Search {
  ContactIsland& island;
  bool at_any_cost;
  IslandReport report = {};
  double tight = accepted * island.tolerance;

  bool solved() const { return report.residual <= tight; }
  void take(const SearchReport& found) {
    report.residual = found.residual;
    report.iterations += found.iterations;
    report.factorisations += found.factorisations;
  }
  /// What was found is where the next search begins.
  void go_on() {
    confine(island);
    for (IslandContact& c : island.contacts) c.start = c.impulse;
    for (IslandRoll& r : island.rolls) r.start = r.impulse;
    for (IslandTie& t : island.ties) t.start = t.impulse;
    for (IslandScalar& s : island.scalars) s.start = s.impulse;
  }
  /// Not where the factor would cost more than it is worth.
  bool lay_out() {
    report.too_dense = !lay_out_all(island, at_any_cost ? most_of_memory : most_updates * island.contacts.size());
    return !report.too_dense;
  }
  void newton(std::uint32_t most) {
    if (!lay_out()) return;
    take(newton_search(island, most));
    report.failed = !solved();
    go_on();
  }
  void proximal() {
    if (!lay_out()) return;
    take(proximal_search(island, most_rounds));
    report.failed = !solved();
    go_on();
  }
  void sweeps(std::uint32_t most, std::uint32_t most_of_all = 0) {
    take(sweep_search(island, most, island.enough, most_of_all));
    go_on();
  }
};

/// How near impulses and their velocities are: Φ of sweeps.cpp without the compliance, ½ |v|²_M + bias·γ - wanted·μ; least in
/// the solution among what the cone allows.
double dual(const ContactIsland& island) {
  double sum = kinetic_energy(island);
  for (const IslandContact& c : island.contacts) sum += dot(c.bias, c.impulse);
  for (const IslandTie& t : island.ties) sum -= dot(t.kept * t.wanted, t.impulse);
  for (const IslandScalar& s : island.scalars) sum += s.bias * s.impulse;
  return sum;
}

/// Of contacts at these impulses, with what ties answer.
double dual_of(ContactIsland& island, Vec3 IslandContact::*start) {
  for (IslandContact& c : island.contacts) c.impulse = c.*start;
  apply_impulses(island);
  if (island.is_tied()) {
    std::vector<BodyLoad> loads;
    answer_of_ties(island, loads);
    apply_impulses(island);
  }
  return dual(island);
}

void choose_start(ContactIsland& island) {
  apply_impulses(island);
  observe(island);
  const auto has_other = [](const IslandContact& c) { return norm2(c.other_start) > 0.0; };
  if (std::none_of(island.contacts.begin(), island.contacts.end(), has_other) || residual(island) <= island.tolerance)
    return;
  const double first = dual_of(island, &IslandContact::start);
  const std::vector<IslandTie> ties = island.ties;
  const std::vector<IslandScalar> scalars = island.scalars;
  if (dual_of(island, &IslandContact::other_start) < first) {
    for (IslandContact& c : island.contacts) c.start = c.other_start;
  } else {
    island.ties = ties;
    island.scalars = scalars;
    for (IslandContact& c : island.contacts) c.impulse = c.start;
    apply_impulses(island);
  }
  observe(island);
}

/// How impulses change the kinetic energy [J]: by how much to first and second order of all of them, and what the law allows.
struct Gain {
  double before = 0.0, first = 0.0, second = 0.0, allowed = 0.0;
  bool is_too_much() const { return !(first + second <= allowed + 1e-12 * (before + second)); }
};

/// By Coulomb's law contacts give no kinetic energy but -Σ bias·γ, where that is above 0; ties what they move by.
Gain gain_of(const ContactIsland& island) {
  Gain g;
  for (const IslandContact& c : island.contacts) g.allowed -= dot(c.bias, c.impulse);
  g.allowed = std::max(g.allowed + work_of_ties(island), 0.0);
  for (const IslandBody& b : island.bodies) {
    const Vec3 dv = b.v - b.v0, dw = b.w - b.w0, momentum = b.inertia * b.w0;
    g.before += 0.5 * (b.mass * norm2(b.v0) + dot(b.w0, momentum));
    g.first += b.mass * dot(b.v0, dv) + dot(momentum, dw);
    g.second += 0.5 * (b.mass * norm2(dv) + dot(dw, b.inertia * dw));
  }
  return g;
}

/// Impulses that miss the law and give more than it allows are made smaller, all alike, until they do not.
void gain_nothing(ContactIsland& island, IslandReport& report) {
  const Gain g = gain_of(island);
  if (!g.is_too_much()) return;
  const double part = std::clamp((g.allowed - g.first) / g.second, 0.0, 1.0);
  for (IslandContact& c : island.contacts) c.impulse *= part;
  for (IslandRoll& r : island.rolls) r.impulse *= part;
  for (IslandTie& t : island.ties) t.impulse *= part;
  for (IslandScalar& s : island.scalars) s.impulse *= part;
  apply_impulses(island);
  observe(island);
  report.residual = residual(island);
}

}  // namespace

bool is_small(const ContactIsland& island) {
  constexpr std::size_t few = 24;
  return island.contacts.size() <= few;
}

bool is_calm(const ContactIsland& island, double kinetic, double part) {
  double mass = 0.0;
  for (const IslandBody& b : island.bodies) mass += b.mass;
  return std::sqrt(2.0 * kinetic / mass) <= part * island.calm;
}

namespace {

/// As exactly as a small island can be, or any.
void search_surely(Search& search) {
  search.newton(most_of_newton);
  for (std::uint32_t i = 0; !search.solved() && i < rounds_of_hard; i++) {
    search.sweeps(sweeps_of_hard);
    search.newton(newton_of_hard);
  }
}

void search_calm(Search& search, SearchEffort effort) {
  const bool is_many = search.island.contacts.size() > many;
  if (is_many && (effort != SearchEffort::all || !is_calm(search.island, kinetic_energy(search.island), very_calm)))
    return search.sweeps(sweeps_of_many);
  const double first = search.report.residual;
  if (effort == SearchEffort::all) search.newton(most_of_newton);
  if (search.solved()) return;
  const bool failed = search.report.failed;
  search.proximal();
  const double left = search.report.residual;
  if (left > search.island.tolerance && left <= search.island.enough) search.newton(most_of_newton);
  search.report.failed = is_many ? left > 0.1 * first : failed || search.report.failed;
}

/// Whether nothing presses without impulses: then nothing does, though friction may hold what would go (Painlevé).
bool opens_alone(ContactIsland& island) {
  start_without_impulses(island);
  observe(island);
  return std::all_of(island.contacts.begin(), island.contacts.end(),
                     [](const IslandContact& c) { return c.u[0] >= 0.0; });
}

}  // namespace

IslandReport solve_island(ContactIsland& island, SearchEffort effort, ContactSearch wanted) {
  prepare(island);
  if (!island.is_tied() && is_small(island) && opens_alone(island))
    for (IslandContact& c : island.contacts) c.start = c.other_start = c.impulse = zero3();
  choose_start(island);
  const bool springs = island.has_springs() && island.contacts.size() <= many;
  Search search{island, wanted == ContactSearch::exact || springs};
  search.report.residual = residual(island);
  if (search.report.residual <= island.tolerance) return search.report;
  const bool sure = wanted != ContactSearch::fast && (is_small(island) || springs);
  const bool surely = sure || wanted == ContactSearch::exact;
  const auto deserves = [&] {
    return surely || (wanted == ContactSearch::automatic && is_calm(island, kinetic_energy(island)));
  };
  const bool exact = deserves();
  if (exact && effort != SearchEffort::sweeps && search.report.residual <= island.enough) search.newton(most_of_newton);
  if (!search.solved()) {
    if (exact)
      search.sweeps(sweeps_before_newton);
    else
      search.sweeps(most_sweeps, !island.is_tied() ? more_sweeps : most_sweeps);
    const bool gets_deep = search.report.residual > deep * island.tolerance && island.contacts.size() <= many;
    if (search.report.residual > island.tolerance &&
        (exact || gets_deep || deserves())) {  // impulses to begin with may have been far off
      if (surely)
        search_surely(search);
      else if (effort != SearchEffort::sweeps)
        search_calm(search, effort);
    }
  }
  if (has_even_loads(island) && wanted != ContactSearch::fast && search.solved() && search.lay_out())
    even_loads(island);
  confine(island);
  apply_impulses(island);
  if (island.is_tied() && gain_of(island).is_too_much()) {
    forget_turning(island);
    search.sweeps(most_sweeps);
  }
  gain_nothing(island, search.report);
  return search.report;
}

}  // namespace pantin
