#include "contacts/solve/impacts.hpp"

#include <algorithm>

#include "contacts/solve/solve.hpp"

namespace pantin {

namespace {

constexpr std::uint32_t most_blow_rounds = 40;
constexpr double least_rise = 1e-12, least_of_tied = 1e-8;  // of the kinetic energy: what the search does not leave

/// Those that near each other, by index; none if nothing of it rebounds.
std::vector<std::size_t> striking(const ContactIsland& island, double slow) {
  std::vector<std::size_t> found;
  bool any = false;
  for (std::size_t k = 0; k < island.contacts.size(); k++) {
    const IslandContact& c = island.contacts[k];
    if (!(c.u[0] < -slow)) continue;
    found.push_back(k);
    any = any || c.restitution > 0.0;
  }
  if (!any) found.clear();
  return found;
}

/// What moving surfaces and ties that move gave [J].
double given(const ContactIsland& island) {
  double sum = 0.0;
  for (const IslandContact& c : island.contacts) sum -= c.bias[1] * c.impulse[1] + c.bias[2] * c.impulse[2];
  for (const IslandTie& t : island.ties) sum += dot(t.kept * t.impulse, t.wanted);
  for (const IslandScalar& s : island.scalars) sum -= s.bias * s.impulse;
  return sum;
}

/// One round, with this part of the rebounds. Returns what it gained from nowhere [J].
double strike(ContactIsland& island, const std::vector<IslandContact>& those, double part, bool first,
              ImpactReport& report) {
  island.contacts = those;
  for (IslandContact& c : island.contacts) {
    const double back = first && c.rebound > 0.0 ? c.rebound : -c.restitution * c.u[0];
    c.bias[0] = -part * back;
    c.start = c.other_start = zero3();
  }
  for (IslandTie& t : island.ties) t.start = zero3();
  for (IslandScalar& s : island.scalars) s.start = 0.0;
  start_without_impulses(island);
  const double before = kinetic_energy(island);
  report.iterations += solve_island(island).iterations;
  return kinetic_energy(island) - before - std::max(0.0, given(island)) -
         (!island.is_tied() ? least_rise : least_of_tied) * before;
}

/// [J] Of the motion against each other of those that strike, by what they gave each other to rebound.
double energy_along(const std::vector<IslandContact>& those, const std::vector<IslandContact>& struck) {
  double sum = 0.0;
  for (std::size_t k = 0; k < those.size(); k++)
    sum -= 0.5 * struck[k].impulse[0] * those[k].u[0] / (1.0 + those[k].restitution);
  return sum;
}

/// Strikes with the largest part of the rebounds that gains nothing beyond -`before` [J], or with none. Returns all that was gained.
template <class Strike>
double strike_without_gain(const ContactIsland& island, double before, Strike&& strike) {
  constexpr int refinements = 4;
  constexpr double enough = 1e-6;  // of the kinetic energy, lost for a part that is too small
  double bad = 1.0, gain_of_bad = before + strike(bad);
  if (gain_of_bad <= 0.0) return gain_of_bad;
  double good = 1.0, gain = gain_of_bad;
  for (const double part : {0.9, 0.7, 0.4, 0.0}) {
    good = part;
    gain = before + strike(part);
    if (gain <= 0.0 || part == 0.0) break;
    bad = part;
    gain_of_bad = gain;
  }
  double last = good;
  for (int i = 0; i < refinements && gain < -enough * kinetic_energy(island); i++) {
    last = good + (bad - good) * std::clamp(gain / (gain - gain_of_bad), 0.05, 0.95);
    const double of_last = before + strike(last);
    (of_last <= 0.0 ? good : bad) = last;
    (of_last <= 0.0 ? gain : gain_of_bad) = of_last;
  }
  return last == good ? gain : before + strike(good);
}

/// Its velocities are those that the next round begins with.
void go_on(ContactIsland& island) {
  for (IslandTie& t : island.ties) t.earlier_impulse += t.kept * t.impulse;
  for (IslandScalar& s : island.scalars) {
    s.earlier_impulse += s.impulse;
    if (s.high == infinity) continue;  // what only pushes does not take an earlier blow back
    s.low -= s.impulse;
    s.high -= s.impulse;
  }
  for (IslandBody& b : island.bodies) {
    b.v0 = b.v;
    b.w0 = b.w;
  }
}

}  // namespace

ImpactReport resolve_impacts(ContactIsland& island, double slow, double done_before, double lifted) {
  ImpactReport report;
  std::vector<IslandContact> all;
  std::vector<IslandRoll> rolls;
  rolls.swap(island.rolls);
  std::vector<Vec3> starts;
  std::vector<double> scalar_starts;
  for (const IslandTie& t : island.ties) starts.push_back(t.start);
  for (const IslandScalar& s : island.scalars) scalar_starts.push_back(s.start);
  while (report.rounds < most_blow_rounds) {
    start_without_impulses(island);
    observe(island);
    const std::vector<std::size_t> now = striking(island, slow);
    if (now.empty()) break;
    std::vector<IslandContact> those;
    for (const std::size_t k : now) those.push_back(island.contacts[k]);
    all.swap(island.contacts);
    const bool first = report.rounds == 0;
    double speed = 1.0;
    if (first && lifted != 0.0) {
      strike(island, those, 1.0, first, report);
      speed = std::sqrt(std::max(0.0, 1.0 - lifted / energy_along(those, island.contacts)));
    }
    done_before = strike_without_gain(island, done_before,
                                      [&](double part) { return strike(island, those, part * speed, first, report); });
    for (std::size_t i = 0; i < now.size(); i++) all[now[i]].impact_impulse += island.contacts[i].impulse;
    all.swap(island.contacts);
    go_on(island);
    report.rounds++;
  }
  rolls.swap(island.rolls);
  for (std::size_t k = 0; k < starts.size(); k++) island.ties[k].start = starts[k];
  for (std::size_t k = 0; k < scalar_starts.size(); k++) island.scalars[k].start = scalar_starts[k];
  return report;
}

}  // namespace pantin
