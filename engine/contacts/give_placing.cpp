// What `place` gives to things, and what ties answer.
#include "contacts/heat.hpp"
#include "contacts/motor_bounds.hpp"
#include "contacts/pass_parts.hpp"

namespace pantin {

namespace {

/// What kicks at both ends of the drift do less [J] than their forces do over the way that it has by what was given since the
/// island's states; gravity's part is told: work at contacts is change of the energy, not of the kinetic one alone.
double work_beside_kicks(const Model& model, const Articulates& articulates, const TouchIsland& island,
                         const TouchSettings& settings, std::span<const BodyLoad> kicks, TouchReport& report) {
  const Vec3 gravity = model.plane.along(settings.gravity);
  double by_laws = 0.0;
  for (std::size_t i = 0; i < island.things.size(); i++) {
    const std::uint32_t thing = island.things[i];
    const bool falls_in_kicks = is_point(thing) && model.points.at_slot(slot_of(thing)).articulate < 0;
    if (kicks.empty() && !falls_in_kicks) continue;
    const BodyState before = island.states[i], now = state_of(model, articulates, thing, settings.drifted);
    const Vec3 by = (now.v - before.v) * (0.5 * settings.h);
    if (falls_in_kicks) report.beside_falls += now.mass * dot(gravity, by);
    if (kicks.empty()) continue;
    const BodyLoad& kick = kicks[number_of(model, thing)];
    by_laws += dot(kick.force, by) + 0.5 * settings.h * dot(kick.moment, now.w - before.w);
  }
  return by_laws + report.beside_falls;
}

/// Notes what each thing got by these impulses, and by what ties answered them.
void note_given(const Model& model, const Articulates& articulates, TouchIsland& island,
                const std::vector<BodyLoad>& impulses, bool drifted) {
  for (std::size_t i = 0; i < island.things.size(); i++) {
    const std::uint32_t thing = island.things[i];
    BodyImpulse given = {static_cast<std::uint32_t>(i), model.plane.along(impulses[i].force), impulses[i].moment};
    if (island_number(model, articulates.size(), thing) < articulates.size()) {
      const BodyState before = island.states[i], after = state_of(model, articulates, thing, drifted);
      given.impulse = (after.v - before.v) * before.mass;
      given.moment = island.problem.bodies[i].inertia * (after.w - before.w);
    }
    if (norm2(given.impulse) + norm2(given.moment) > 0.0) island.given.push_back(given);
  }
}

/// Whether contacts stop a motor that has no limit but that of what touches.
bool is_jammed(const IslandScalar& s, const ScalarRow& row, const Condition& c) {
  constexpr double moves = 1e-2;  // of the wanted velocity
  if (std::isinf(c.bound_in_touch) || !s.is_at_bound()) return false;
  return (s.u - s.bias) * row.wanted <= moves * row.wanted * row.wanted;
}

/// Adds what scalars within bounds answer to contacts, and notes it. Where one reached a bound the drift, which asks for that force
/// again, gives it; not where it is jammed: what then holds it must not be taken back alone.
ImpulseWork hold_scalars(const Articulates& articulates, TouchIsland& island, std::vector<BodyLoad>& loads) {
  for (std::size_t k = 0; k < island.scalars.size(); k++) {
    const IslandScalar& s = island.problem.scalars[k];
    const TouchScalar& from = island.scalars[k];
    Articulate& a = *articulates[from.articulate];
    Condition& c = condition(a, a.rows[from.row.row()]);
    const bool jams = is_jammed(s, from.row, c);
    if (!s.is_bounded() || (s.is_at_bound() && !jams)) continue;
    const double impulse = s.impulse + (jams ? s.earlier_impulse : 0.0);
    if (jams) jam(c);
    add_load(island.problem, loads, s, impulse);
    add_work(island.answered, articulates, from, impulse, jams ? 0.0 : from.row.wanted);
    island.held.push_back(from);
    island.held.back().given = impulse;
  }
  return island.answered;
}

/// The drift begins with forces of springs as they were foreseen: what contacts give may be far more than springs had.
void expect_pulls(const Articulates& articulates, const TouchIsland& island, double h) {
  for (std::size_t k = 0; k < island.rows.size(); k++) {
    const IslandTie& t = island.problem.ties[k];
    if (t.softness == 0.0) continue;
    Articulate& a = *articulates[island.rows[k][0]];
    const std::size_t row = island.rows[k][1];
    if (a.expected.size() != a.rows.size()) a.expected.assign(a.rows.size(), vec(infinity, 0.0, 0.0));
    if (!finite(a.expected[row])) a.expected[row] = t.pull;
    a.expected[row] += (t.earlier_impulse + t.kept * t.impulse) * (2.0 / h);
  }
}

/// Gives what was found, and what ties answer; notes what each thing got of both.
void give_to_island(TouchSpace& space, Model& model, const Articulates& articulates, const Contacts& contacts,
                    const TouchSettings& settings, std::span<const BodyLoad> kicks, TouchIsland& island,
                    TouchReport& report) {
  const double before = kinetic_energy_now(model, island);
  HeatOf heat(model, articulates, contacts, settings.drifted, island.placed, island.heat);
  for (const std::uint32_t a : island.articulates) articulates[a]->touches = true;
  std::vector<BodyLoad> loads(island.things.size());
  add_contact_loads(island.problem, loads);
  ImpulseWork ties = hold_scalars(articulates, island, loads);
  const auto note = [&](double sign) {
    for (std::size_t i = 0; i < island.things.size(); i++)
      if (const std::size_t k = number_of(model, island.things[i]); k < space.placing_work.size())
        space.placing_work[k] += sign * kinetic_energy(model, island.states[i], island.things[i]);
  };
  note(-1.0);
  std::vector<std::vector<DrivenVelocity>> driven;
  for (const std::uint32_t a : island.articulates)
    driven.push_back(driven_velocities(*articulates[a], model, settings));
  give(model, island, loads);
  expect_pulls(articulates, island, settings.h);
  ImpulseWork answered;
  for (std::size_t k = 0; k < driven.size(); k++)
    answered += answer_of_ties(*articulates[island.articulates[k]], model, settings, driven[k]);
  ties += answered;
  if (island.solved) {
    tell_reactions(articulates, island, settings.step, false);
  } else {
    island.held.clear();
    note_given(model, articulates, island, loads, settings.drifted);
    island.answered += answered;
  }
  note(1.0);
  report.ties += ties;
  const double work = kinetic_energy_now(model, island) - before - ties.all() -
                      work_beside_kicks(model, articulates, island, settings, kicks, report);
  report.work += work;
  heat.add(work);
}

}  // namespace

void give_placing(TouchSpace& space, Workers& workers, Model& model, const Articulates& articulates, Contacts& contacts,
                  const TouchSettings& settings, std::span<const BodyLoad> kicks, TouchReport& sum) {
  const std::span<TouchIsland> islands = std::span(space.placing).first(space.placed);
  space.placing_work.assign(space.index.size(), 0.0);
  space.turned.assign(space.index.size(), zero3());
  each_island(workers, islands, sum, [&](TouchIsland& island, TouchReport& report) {
    report = {};
    if (!island.placed.empty()) give_to_island(space, model, articulates, contacts, settings, kicks, island, report);
    island.placed_work = report.work;
  });
  collect_heat(contacts, islands);
  hold_again(articulates);
}

}  // namespace pantin
