#include "forces/forces.hpp"

#include <algorithm>
#include <utility>

#include "articulates/articulate.hpp"
#include "forces/curves.hpp"
#include "forces/disturb.hpp"
#include "forces/forces_parts.hpp"
#include "forces/integrator.hpp"
#include "forces/solved.hpp"
#include "laws/draws_noise.hpp"
#include "laws/machine_code.hpp"
#include "world/share_blocks.hpp"

namespace pantin {

namespace {

/// Laws over no more pairs than this tell their energy in every step, others in every sixteenth.
constexpr std::size_t few_pairs = 4096;

}  // namespace

double run_laws(const World& world, Forces& f, const Instant& instant, bool with_energy) {
  double energy = 0.0;
  each_element(f, [&](ActingElement& a) {
    if (a.law->velocity_dependent || (a.solved && !(with_energy && a.law->has_energy()))) return;
    const double told = run_law(world, f, a, instant, with_energy);
    if (with_energy) energy += a.energy = told;
  });
  return energy;
}

void keep_in_plane(const Plane& plane, Sites& sites) {
  if (!plane.flat()) return;
  for (auto* forces : {&sites.force, &sites.nonconservative_force})
    for (std::size_t i = 0; i < sites.n; i++) (*forces)[i] = plane.along((*forces)[i]);
}

double run_still_laws(const World& world, Forces& f, const Instant& instant, bool with_energy) {
  share_each(world, f.sites.force.size(), [&](std::size_t i) { f.sites.force[i] = zero3(); });
  if (f.nonconservative) std::fill(f.sites.nonconservative_force.begin(), f.sites.nonconservative_force.end(), zero3());
  return run_laws(world, f, instant, with_energy);
}

void collect(const World& world, Forces& f) {
  keep_in_plane(world.plane, f.sites);
  for (Receiver& m : f.receivers) {
    m.force = m.torque = m.nonconservative_force = m.nonconservative_torque = zero3();
    m.damper_force = m.damper_torque = m.solved_force = m.solved_torque = zero3();
    m.solved = false;
  }
  for (const Attached& a : f.attached) {
    Receiver& m = f.receivers[a.receiver];
    m.force += f.sites.force[a.site];
    m.torque += world.plane.about(cross(a.r, f.sites.force[a.site]));
    m.nonconservative_force += f.sites.nonconservative_force[a.site];
    m.nonconservative_torque += world.plane.about(cross(a.r, f.sites.nonconservative_force[a.site]));
    const Vec3 damping = world.plane.along(damping_of(f, a.site));
    m.damper_force += damping;
    m.damper_torque += world.plane.about(cross(a.r, damping));
  }
}

void refresh_ages(const World& world, Forces& f, double time) {
  Sites& s = f.sites;
  for (std::size_t c = 0; c < s.names.size(); c++) {
    if (s.names[c] == "age")
      for (std::size_t i = 0; i < s.n; i++)
        if (s.particle[i] != Forces::none)
          s.attributes[c][i] = std::fmax(0.0, time - world.particles.at_slot(s.particle[i]).born);
    double* const column = s.attributes[c].data();
    if (f.followed[c]) follow_curves(world, s.names[c], time, s.particle, {&column, 1});
  }
}

namespace {

bool follows(const Forces& f) {
  return std::any_of(f.followed.begin(), f.followed.end(), [](char c) { return c != 0; });
}

/// Whether solved laws read what changes by itself.
bool changes(const Forces& f) {
  return std::any_of(f.connections.begin(), f.connections.end(), [&](const ActingConnections& a) {
    const auto& names = f.sites.names;
    return a.solved && (a.law->timed || follows(f) || std::find(names.begin(), names.end(), "age") != names.end());
  });
}

/// Finds what of the non-conservative forces is noise, where errors are to be told without it.
void find_noise(const World& world, Forces& f, const Instant& instant) {
  f.noise.clear();
  if (!world.settings.accuracy || !f.noisy) return;
  Instant silent = instant;
  silent.silent = true;
  const KeptForces kept(f.sites);
  f.noise.assign(f.sites.n, zero3());
  for (const bool loud : {true, false}) {
    std::fill(f.sites.nonconservative_force.begin(), f.sites.nonconservative_force.end(), zero3());
    each_element(f, [&](ActingElement& a) {
      if (draws_noise(*a.law) && !a.law->thermal) run_law(world, f, a, loud ? instant : silent);
    });
    for (std::size_t i = 0; i < f.sites.n; i++) f.noise[i] += f.sites.nonconservative_force[i] * (loud ? 1.0 : -1.0);
  }
}

/// Forces at the positions and velocities that the sites now have; the energy where it is asked for.
double evaluate(const World& world, Forces& f, const Instant& instant, bool with_energy) {
  refresh_ages(world, f, instant.time);
  const double energy = run_still_laws(world, f, instant, with_energy);
  if (f.velocity_dependent) {
    f.still.assign(f.sites.nonconservative_force.begin(), f.sites.nonconservative_force.end());
    find_velocity_slopes(world, f, instant);
  }
  find_noise(world, f, instant);
  collect(world, f);
  return energy;
}

}  // namespace

Instant instant_of(const World& world, double time, std::uint64_t number) {
  return {time, number, world.settings.seed};
}

void start(const World& world, Forces& f) {
  read_positions(world, f, false);
  build_neighbours(world, f, false);
  if (!f.rows) arrange(world, f);
  read_velocities(world, f, false);
}

namespace {

bool tells_energy(const World& world, const Forces& f) {
  std::size_t pairs = 0;
  for (const ActingInteraction& a : f.interactions) pairs += a.pairs.neighbours.pairs();
  for (const ActingConnections& a : f.connections) pairs += a.bond_list.size();
  // Where particles come and go it will be asked for before the next step.
  return pairs <= few_pairs || (world.steps + 1) % 16 == 0 || f.settled_in == world.steps + 1;
}

}  // namespace

bool acting_now(const World& world) {
  return world.forces && !world.force_elements_changed && !world.forces->unsettled;
}

namespace {

/// Energy of the laws at the present positions, with ages of another time [s]; forces stay, ages do not.
double energy_at_ages(const World& world, Forces& f, double time) {
  const KeptForces kept(f.sites);
  refresh_ages(world, f, time);
  return run_laws(world, f, instant_of(world, time, world.instant), true);
}

bool stiffness_is_due(World& world) { return std::exchange(world.stiffness_unknown, false) || world.steps % 64 == 0; }

/// The energy of the laws comes into the balance.
void bring_in_energy(World& world) {
  Forces& f = *world.forces;
  each_element(f, [](ActingElement& a) { a.at_first = a.energy; });
  if (world.steps == 0)
    world.start_energy += f.energy;
  else
    post(world, Source::law, f.energy);
}

/// Reads the present state after an edit that left most sites as they were.
void start_again(const World& world, Forces& f) {
  read_positions(world, f, false);
  build_neighbours_in_order(world, f);
  arrange(world, f);
  if (f.velocity_dependent) read_velocities(world, f, false);
}

/// Forces of the present state with laws, or on sites, that were just changed.
void start_acting(World& world) {
  Forces& f = *world.forces;
  if (stiffness_is_due(world) && find_too_stiff(world, f)) {
    world.force_elements_changed = true;
    return;
  }
  set_solved_inputs(world, false);
  f.energy = evaluate(world, f, instant_of(world, world.time, world.instant), true);
  bring_in_energy(world);
}

/// Once, that laws do without code of the processor.
void tell_refusal(World& world) {
  const std::string said = "the system lets no program write code and run it: laws take up to twice as long";
  const auto is_it = [&](const LogLine& line) { return line.text == said; };
  if (machine_code_refused() && std::none_of(world.log.begin(), world.log.end(), is_it))
    log_line(world, "warning", said);
}

void make_forces(World& world) {
  world.forces = build_forces(world);
  world.force_elements_changed = false;
  for (const auto& articulate : world.articulates) articulate->pulled = false;
  if (!world.forces) {
    world.sub_steps = {};
    return;
  }
  find_receivers(world, *world.forces);
  start(world, *world.forces);
  start_acting(world);
  tell_refusal(world);
}

/// The same where edits changed what some sites are, or the state of what they are on.
void settle(World& world) {
  Forces& f = *world.forces;
  f.settled_in = world.steps + 1;
  if (!can_change_members(world, f)) {
    make_forces(world);
  } else if (f.told && are_apart(world, f)) {
    f.energy += change_members_apart(world, f);
    bring_in_energy(world);
  } else {
    const bool elsewhere = f.elsewhere;
    change_members(world, f);
    if (f.sites.n == 0) return make_forces(world);
    if (elsewhere) find_receivers(world, f);
    start_again(world, f);
    start_acting(world);
  }
}

}  // namespace

void refresh_laws(World& world) {
  if (world.force_elements_changed) {
    make_forces(world);
  } else if (world.forces && world.forces->unsettled) {
    settle(world);
  } else if (world.forces && stiffness_is_due(world) && find_too_stiff(world, *world.forces)) {
    internal::disturb_forces(world);
  }
  if (world.force_elements_changed) return;
  if (world.forces && changes(*world.forces)) set_solved_inputs(world, true);
}

void begin_kick(World& world) {
  if (!world.forces || !follows(*world.forces)) return;
  // What changes with age alone is work from outside: half of it at the positions before the drift, half at those after.
  Forces& f = *world.forces;
  const double energy = f.energy;
  post(world, Source::law, 0.5 * (energy_at_ages(world, f, kick_end(world)) - energy));
}

void renew_pairs(World& world) {
  if (!world.forces) return;
  Forces& f = *world.forces;
  read_positions(world, f, true);
  if (f.rows && f.skin.spent(f.sites)) build_neighbours(world, f, true);
}

void find_forces_again(World& world) {
  Forces& f = *world.forces;
  read_positions(world, f, false);
  if (f.rows && f.skin.spent(f.sites)) build_neighbours(world, f, false);
  read_velocities(world, f, false);
  f.energy = evaluate(world, f, instant_of(world, world.time, world.instant), true);
}

void find_forces_after_drift(World& world) {
  if (!world.forces) return;
  Forces& f = *world.forces;
  if (f.velocity_dependent) read_velocities(world, f, true);
  world.instant++;
  const bool end_of_kick = rule_of(world).kicks || world.stage.last,
             end_of_step = world.stage.index + 1 == stage_count(world);
  const bool ages = follows(f) && end_of_kick;
  f.told = ages || (end_of_step && tells_energy(world, f));
  const double before = ages ? energy_at_ages(world, f, kick_start(world)) : 0.0;
  f.energy = evaluate(world, f, instant_of(world, time_within(world, world.stage.to), world.instant), f.told);
  if (ages) post(world, Source::law, 0.5 * (f.energy - before));
}

}  // namespace pantin
