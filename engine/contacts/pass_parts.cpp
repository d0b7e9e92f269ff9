#include "contacts/pass_parts.hpp"

#include <algorithm>
#include <cmath>

#include "articulates/solve/momenta.hpp"
#include "articulates/solve/node_batches.hpp"
#include "articulates/solve/project.hpp"
#include "articulates/solve/state.hpp"
#include "articulates/solve/wanted_velocities.hpp"

namespace pantin {

void TouchReport::operator+=(const TouchReport& more) {
  work += more.work;
  belts += more.belts;
  wrong += more.wrong;
  taken_back += more.taken_back;
  from_rest += more.from_rest;
  beside_falls += more.beside_falls;
  ties += more.ties;
  islands += more.islands;
  contacts += more.contacts;
  iterations += more.iterations;
  unsolved += more.unsolved;
}

void give(Model& model, const TouchIsland& island, const std::vector<BodyLoad>& loads) {
  for (std::size_t i = 0; i < loads.size(); i++)
    add_momenta(model, island.states[i], island.things[i], model.plane.along(loads[i].force), loads[i].moment);
}

namespace {

void begin_answers_now(Articulate& a, Model& model, const TouchSettings& settings) {
  if (!settings.drifted) load(a, model, settings.gravity);
  drop_factor(a, FactorOf::projection);
  const WantedVelocities as_now(a, settings.step, settings.at);
  begin_answers(a, 0.0);
  for (std::size_t b = 0; b < a.batches.size(); b++) read_momenta(a, b);
}

}  // namespace

void let_overdriven_give_way_now(Articulate& a, Model& model, const TouchSettings& settings) {
  for (Condition& c : a.conditions) c.gives_way = c.ranged;
  if (std::none_of(a.conditions.begin(), a.conditions.end(), is_limited)) return;
  begin_answers_now(a, model, settings);
  answer(a);
  let_answers_give_way(a, settings.h);
  drop_factor(a, FactorOf::projection);
}

std::vector<DrivenVelocity> driven_velocities(Articulate& a, Model& model, const TouchSettings& settings) {
  if (std::none_of(a.conditions.begin(), a.conditions.end(), [](const Condition& c) { return c.driven; })) return {};
  begin_answers_now(a, model, settings);
  keep_driven_velocities(a);
  drop_factor(a, FactorOf::projection);
  std::vector<DrivenVelocity> velocities;
  for (const Condition& c : a.conditions) velocities.push_back({c.wanted, c.worked_at});
  return velocities;
}

ImpulseWork answer_of_ties(Articulate& a, Model& model, const TouchSettings& settings,
                           std::span<const DrivenVelocity> driven) {
  begin_answers_now(a, model, settings);
  for (std::size_t k = 0; k < driven.size(); k++)
    if (Condition& c = a.conditions[k]; c.driven) {
      c.wanted = driven[k].now;
      c.worked_at = driven[k].in_drift;
    }
  const bool at_distance = acts_at_distance(a);
  const Momenta momenta = at_distance ? momenta_of(a) : Momenta{};
  ImpulseWork work = answer(a);
  for (std::size_t b = 0; b < a.batches.size(); b++) tell_momenta(a, b);
  if (at_distance) work.anchors += restore_momenta(a, momenta);
  drop_factor(a, FactorOf::projection);
  if (!settings.drifted)
    for (const Node& n : a.nodes) store(n, model);
  return work;
}

void add_work(ImpulseWork& work, const Articulates& articulates, const TouchScalar& s, double impulse,
              double velocity) {
  const double by = std::clamp(velocity, std::min(0.0, s.row.wanted), std::max(0.0, s.row.wanted));
  (s.row.is_angular(*articulates[s.articulate]) ? work.angular_rows : work.anchors) += impulse * by;
}

double slow_of(const TouchSettings& settings, const ContactIsland& island) {
  return std::max(2.0 * norm(settings.gravity) * settings.h, 1e4 * island.tolerance);
}

void keep_rolls(const ContactIsland& island, Contacts& contacts, const std::vector<std::size_t>& to,
                Vec3 Contact::*moment) {
  for (const IslandRoll& r : island.rolls) contacts.list[to[r.contact]].*moment = moment_of(island, r, r.impulse);
}

void keep_tie_impulses(const Articulates& articulates, const TouchIsland& island, Pass pass) {
  for (const std::uint32_t a : island.articulates)
    articulates[a]->tie_impulses[number(pass)].assign(articulates[a]->rows.size(), zero3());
  for (std::size_t k = 0; k < island.rows.size(); k++)
    articulates[island.rows[k][0]]->tie_impulses[number(pass)][island.rows[k][1]] += island.problem.ties[k].impulse;
  for (const std::uint32_t a : island.articulates)
    if (!island.scalars.empty()) articulates[a]->scalar_impulses[number(pass)].assign(articulates[a]->rows.size(), 0.0);
  for (std::size_t k = 0; k < island.scalars.size(); k++)
    articulates[island.scalars[k].articulate]->scalar_impulses[number(pass)][island.scalars[k].row.row()] =
        island.problem.scalars[k].impulse;
}

void tell_reactions(const Articulates& articulates, const TouchIsland& island, double step, bool bounded) {
  for (const std::uint32_t a : island.articulates)
    articulates[a]->reaction.resize(articulates[a]->rows.size(), zero3());
  for (std::size_t k = 0; k < island.rows.size(); k++) {
    const IslandTie& t = island.problem.ties[k];
    if (t.softness > 0.0) continue;
    articulates[island.rows[k][0]]->reaction[island.rows[k][1]] += t.kept * t.impulse / step;
  }
  for (std::size_t k = 0; k < island.scalars.size(); k++) {
    const TouchScalar& s = island.scalars[k];
    if (s.row.is_bounded() && !bounded) continue;
    for (const ScalarRow::Term& term : s.row.terms)
      articulates[s.articulate]->reaction[term.row] += term.along * (island.problem.scalars[k].impulse / step);
  }
}

void collect_heat(Contacts& contacts, std::span<TouchIsland> islands) {
  if (!contacts.heat_kept) return;
  for (TouchIsland& island : islands)
    contacts.new_heat.insert(contacts.new_heat.end(), island.heat.begin(), island.heat.end());
}

namespace {

constexpr double exact_enough = 100.0;  // tolerances

}  // namespace

bool solve_pass(Contacts& contacts, TouchIsland& island, Pass pass, ContactSearch search, TouchReport& report) {
  constexpr std::uint8_t waits_after = 4, longest_wait = 7, dense = 255;
  std::uint8_t failures = 0, wait = 0;
  const auto all = [&](auto use) {
    for (const std::uint32_t thing : island.things)
      if (const std::uint32_t slot = slot_of(thing); !is_point(thing))
        use(contacts.bodies[slot]);
      else if (slot < contacts.points.size())
        use(contacts.points[slot]);
  };
  all([&](const TouchedBody& body) {
    failures = std::max(failures, body.failures[number(pass)]);
    wait = std::max(wait, body.wait[number(pass)]);
  });
  const SearchEffort effort = wait == 0           ? SearchEffort::all
                              : failures == dense ? SearchEffort::sweeps
                                                  : SearchEffort::rounds;
  const IslandReport found = solve_island(island.problem, effort, search);
  count(found, island.problem, report);
  if (wait > 0) {
    wait--;
  } else {
    const std::uint8_t again = failures < waits_after ? failures + 1 : waits_after;
    failures = found.too_dense ? dense : found.failed ? again : 0;
    wait = failures < waits_after ? 0 : longest_wait;
  }
  all([&](TouchedBody& body) {
    body.failures[number(pass)] = failures;
    body.wait[number(pass)] = wait;
  });
  island.missed = found.residual > exact_enough * island.problem.tolerance;
  return !island.missed && is_even(island.problem);
}

}  // namespace pantin
