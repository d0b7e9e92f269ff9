#pragma once
// What the passes of touch have in common.
#include <span>

#include "contacts/gather.hpp"
#include "contacts/solve/solve.hpp"

namespace pantin {

/// [J] of all that is in it.
inline double kinetic_energy_now(const Model& model, const TouchIsland& island) {
  double sum = 0.0;
  for (std::size_t i = 0; i < island.things.size(); i++)
    sum += kinetic_energy(model, island.states[i], island.things[i]);
  return sum;
}

/// Begins the search of rolls with these moments of their contacts.
inline void start_rolls(ContactIsland& island, const Contacts& contacts, const std::vector<std::size_t>& from,
                        Vec3 Contact::*moment) {
  for (IslandRoll& r : island.rolls) {
    const Vec3 along = to_frame(island.contacts[r.contact], contacts.list[from[r.contact]].*moment);
    for (int k = 0; k < 3; k++) r.start[k] = r.lever[k] > 0.0 ? along[k] / r.lever[k] : 0.0;
  }
}

/// Begins the search of ties with what they bore in this pass, `place` or `meet`, of the last step.
inline void start_ties(TouchIsland& island, const Articulates& articulates, Pass pass) {
  for (std::size_t k = 0; k < island.rows.size(); k++) {
    const Articulate& a = *articulates[island.rows[k][0]];
    IslandTie& t = island.problem.ties[k];
    const std::vector<Vec3>& last = a.tie_impulses[number(pass)];
    if (last.size() == a.rows.size()) t.start = t.kept * last[island.rows[k][1]];
  }
  for (std::size_t k = 0; k < island.scalars.size(); k++) {
    const Articulate& a = *articulates[island.scalars[k].articulate];
    const std::vector<double>& last = a.scalar_impulses[number(pass)];
    if (last.size() == a.rows.size()) island.problem.scalars[k].start = last[island.scalars[k].row.row()];
  }
}

/// Impulses of contacts that were foreseen act where they are met: before the drift of all, after it of those that it held.
inline void act_where_met(TouchIsland& island, const Contacts& contacts, bool after) {
  for (std::size_t k = 0; k < island.contacts.size(); k++) {
    const Contact& from = contacts.list[island.contacts[k]];
    if (!from.foreseen || from.from_before != after) continue;
    IslandContact& c = island.problem.contacts[k];
    c.ra = from.arm_a;
    if (c.b >= 0) c.rb = from.arm_b;
  }
}

/// Begins a search for velocities with which contacts part or stay, from the impulses of the last step.
inline void start_meeting(TouchIsland& island, const Contacts& contacts, const Articulates& articulates) {
  ContactIsland& problem = island.problem;
  for (std::size_t k = 0; k < problem.contacts.size(); k++) {
    const Contact& from = contacts.list[island.contacts[k]];
    IslandContact& c = problem.contacts[k];
    c.bias = to_frame(c, from.belt);
    c.bias[0] = 0.0;
    c.start = to_frame(c, from.total);
  }
  start_rolls(problem, contacts, island.contacts, &Contact::total_moment);
  start_ties(island, articulates, Pass::meet);
}

/// Sets what scalars want in a drift of h [s], with what their forces may give in `time` [s] beside `drifted` of it, in which they
/// had the forces of the last drift.
inline void set_scalars(TouchIsland& island, const Articulates& articulates, double h, double time,
                        double drifted = 0.0) {
  for (std::size_t k = 0; k < island.scalars.size(); k++) {
    const ScalarRow& row = island.scalars[k].row;
    IslandScalar& s = island.problem.scalars[k];
    s.bias = std::max(0.0, row.room) / h - row.wanted;
    if (!row.is_bounded()) continue;
    const Vec3 along = row.terms.front().along;
    const Articulate& a = *articulates[island.scalars[k].articulate];
    const double force = dot(force_in_drift(a, row.row()), along) / norm2(along);
    const auto impulse = [&](double bound) { return std::isinf(bound) ? bound : bound * time - force * drifted; };
    s.low = std::min(0.0, impulse(row.lower));
    s.high = std::max(0.0, impulse(row.upper));
  }
}

/// Rows of limited force, which gave way to contacts, hold as before.
inline void hold_again(const Articulates& articulates) {
  for (const auto& articulate : articulates)
    for (Condition& c : articulate->conditions) c.gives_way = false;
}

inline void count(const IslandReport& found, const ContactIsland& problem, TouchReport& report) {
  report.islands++;
  report.contacts += static_cast<std::uint32_t>(problem.contacts.size());
  report.iterations += found.iterations;
  if (found.residual > problem.enough) report.unsolved++;
}

/// Does it to each island, with a report of its own, and adds these up in the order of the islands.
template <class F>
void each_island(Workers& workers, std::span<TouchIsland> islands, TouchReport& report, F&& f) {
  share_islands(workers, islands, [&](TouchIsland& island) { f(island, island.report); });
  for (const TouchIsland& island : islands) report += island.report;
}

void give(Model& model, const TouchIsland& island, const std::vector<BodyLoad>& loads);

/// Of what touches nothing: stops give way, and rows of limited force where they would have to give more than it.
void let_overdriven_give_way_now(Articulate& a, Model& model, const TouchSettings& settings);

/// [m/s] How fast what is driven is now, and in the mean of the drift, unless it jumps: at that it works.
struct DrivenVelocity {
  Vec3 now, in_drift;
};

/// What ties answer to impulses of contacts alone, exactly: those of gravity and of turning belong to the drift.
/// What is driven stays as fast as `driven` says.
ImpulseWork answer_of_ties(Articulate& a, Model& model, const TouchSettings& settings,
                           std::span<const DrivenVelocity> driven = {});
/// (conditions) None where nothing is driven.
std::vector<DrivenVelocity> driven_velocities(Articulate& a, Model& model, const TouchSettings& settings);

/// What a scalar gives that moves with `velocity`, as far as it wants to: a motor that is stopped gives nothing.
void add_work(ImpulseWork& work, const Articulates& articulates, const TouchScalar& s, double impulse, double velocity);

/// [m/s] What nears faster rebounds.
double slow_of(const TouchSettings& settings, const ContactIsland& island);

void keep_rolls(const ContactIsland& island, Contacts& contacts, const std::vector<std::size_t>& to,
                Vec3 Contact::*moment);

void keep_tie_impulses(const Articulates& articulates, const TouchIsland& island, Pass pass);

/// Adds what ties bear by these impulses to what their rows tell; scalars within bounds where that is `bounded`.
void tell_reactions(const Articulates& articulates, const TouchIsland& island, double step, bool bounded);

void collect_heat(Contacts& contacts, std::span<TouchIsland> islands);

/// Solves it, exactly if its bodies are not waiting: where that failed some times in a row it is tried now and then. Whether it
/// is solved as exactly as can be, among bodies of like masses.
bool solve_pass(Contacts& contacts, TouchIsland& island, Pass pass, ContactSearch search, TouchReport& report);

}  // namespace pantin
