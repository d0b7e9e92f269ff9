#include "articulates/drift.hpp"

#include "articulates/midpoint.hpp"
#include "articulates/project.hpp"
#include "articulates/stiff.hpp"
#include "phases/phases.hpp"

namespace pantin::phases {

namespace {

void drift_points(World& world) {
  for (std::uint32_t slot : world.loose_points) {
    FreeMotion& m = world.free_motion[slot];
    m.x += m.v * world.settings.step;
  }
}

void drift_bodies(World& world) {
  const bool euler = world.settings.integrator == Integrator::euler;
  Node n{};
  n.is_body = true;
  for (std::uint32_t slot : world.loose_bodies) {
    const Motion& m = world.motion[slot];
    n.slot = slot;
    n.mass = m.mass;
    n.inverse_mass = 1.0 / m.mass;
    n.inertia = m.inertia;
    n.inverse_inertia = inverse_inertia(m);
    n.turns = m.freedom != Freedom::point;
    load(n, world, world.settings.gravity);
    const Vec3 x = n.x0;
    const double before = kinetic_energy(n);
    euler ? drift_euler_alone(n, world.settings.step) : drift_alone(n, world.settings.step);
    if (norm2(m.force) > 0.0 || norm2(m.torque) > 0.0)
      post(world, Source::event, kinetic_energy(n) - before - n.mass * dot(world.settings.gravity, n.x0 - x));
    store(n, world);
  }
}

void post_work(World& world, const DriftReport& report) {
  post(world, Source::hand, report.work);
  post(world, Source::motor, report.motor);
  post(world, Source::limit, report.limit);
}

/// What the energies of solved laws gave.
void post_solved_laws(World& world, const Articulate& articulate) {
  Ledger& ledger = world.ledger;
  if (!ledger.kept) return;
  for (const Condition& c : articulate.conditions) {
    if (!c.stiff) continue;
    std::shared_ptr<const Law> law = world.connections[c.stiff->connection].law;
    for (double given : c.stiff->given) {
      ledger.laws += given;
      ledger.kicks[law->name] += given;
      ledger.posted += std::fabs(given);
      law = law->also;
    }
  }
}

void count(World& world, const DriftReport& report) {
  world.stats.newton_iterations += report.iterations;
  world.stats.factorisations += report.factorisations;
  world.stats.halved_steps += report.halved;
  world.stats.safe_steps += report.safe;
  world.stats.projections += report.projections;
  world.stats.solves++;
  world.stats.worst_iterations = std::max(world.stats.worst_iterations, report.iterations);
  world.work += report.open_work;
  world.open_work += report.open_work;
  world.ledger.posted += std::fabs(report.open_work);
  post_work(world, report);
  post(world, Source::edit, report.met);
}

DriftSettings drift_settings(const World& world) {
  return {world.settings.step, world.settings.gravity, world.settings.tolerance, world.settings.energy_return};
}

}  // namespace

void drift(World& world) {
  const Timed timed(world.profile, Phase::drift);
  const LedgerMark before = ledger_mark(world, false);
  drift_points(world);
  drift_bodies(world);
  const DriftSettings settings = drift_settings(world);
  for (auto& articulate : world.articulates) {
    load(*articulate, world, settings.gravity);
    DriftReport report;
    if (world.settings.integrator == Integrator::euler)
      drift_euler(*articulate, settings, report);
    else
      pantin::drift(*articulate, settings, report);
    tell_tensions(*articulate, world);
    post_solved_laws(world, *articulate);
    count(world, report);
    if (report.offsets > 0)
      log_line(world, "notice", "a gap that no motion can close was taken as a constant offset of its hinges");
  }
  post_drift(world, before);
}

void project_velocities(World& world) {
  const Timed timed(world.profile, Phase::project_velocities);
  if (world.settings.integrator == Integrator::euler) return;
  const LedgerMark before = ledger_mark(world, true);
  double returned = 0.0;
  const DriftSettings settings = drift_settings(world);
  for (auto& articulate : world.articulates) {
    DriftReport report;
    pantin::project_velocities(*articulate, settings, report);
    world.stats.projections += report.projections;
    post_work(world, report);
    returned += report.returned;
  }
  post_projection(world, before, returned);
}

}  // namespace pantin::phases
