#include "articulates/drift.hpp"

#include "articulates/midpoint.hpp"
#include "articulates/project.hpp"
#include "articulates/stiff.hpp"
#include "phases/phases.hpp"
#include "phases/share.hpp"

namespace pantin::phases {

namespace {

void drift_points(World& world) {
  constexpr std::size_t enough = 4096;
  share_blocks(world, world.loose_points.size(), enough, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; i++) {
      FreeMotion& m = world.free_motion[world.loose_points[i]];
      m.x += m.v * world.settings.step;
    }
  });
}

/// Returns the work of pushes and twists [J].
double drift_body(World& world, std::uint32_t slot) {
  const bool euler = world.settings.integrator == Integrator::euler;
  const Vec3 gravity = world.settings.gravity;
  const Motion& m = world.motion[slot];
  Node n{};
  n.is_body = true;
  n.slot = slot;
  n.mass = m.mass;
  n.inverse_mass = 1.0 / m.mass;
  n.inertia = m.inertia;
  n.inverse_inertia = inverse_inertia(m);
  n.turns = m.freedom != Freedom::point;
  load(n, world, gravity);
  const Vec3 x = n.x0;
  const double before = kinetic_energy(n);
  euler ? drift_euler_alone(n, world.settings.step) : drift_alone(n, world.settings.step);
  const bool pushed = norm2(m.force) > 0.0 || norm2(m.torque) > 0.0;
  store(n, world);
  return pushed ? kinetic_energy(n) - before - n.mass * dot(gravity, n.x0 - x) : 0.0;
}

void drift_bodies(World& world) {
  constexpr std::size_t enough = 64;
  if (world.pushed) {  // their work is summed in order
    for (std::uint32_t slot : world.loose_bodies) post(world, Source::event, drift_body(world, slot));
    return;
  }
  share_blocks(world, world.loose_bodies.size(), enough, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; i++) drift_body(world, world.loose_bodies[i]);
  });
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
  world.stats.solves++;
  world.stats.worst_iterations = std::max(world.stats.worst_iterations, report.iterations);
  world.work += report.open_work;
  world.open_work += report.open_work;
  world.ledger.posted += std::fabs(report.open_work);
  post_work(world, report);
  post(world, Source::edit, report.met);
  if (report.offsets > 0)
    log_line(world, "notice", "a gap that no motion can close was taken as a constant offset of its hinges");
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
  const bool euler = world.settings.integrator == Integrator::euler;
  share_articulates(world, [&](Articulate& articulate) {
    load(articulate, world, settings.gravity);
    articulate.report = {};
    euler ? drift_euler(articulate, settings, articulate.report)
          : pantin::drift(articulate, settings, articulate.report);
  });
  for (const auto& articulate : world.articulates) {
    tell_tensions(*articulate, world);
    post_solved_laws(world, *articulate);
    count(world, articulate->report);
  }
  post_drift(world, before);
}

void project_velocities(World& world) {
  const Timed timed(world.profile, Phase::project_velocities);
  if (world.settings.integrator == Integrator::euler) return;
  const LedgerMark before = ledger_mark(world, true);
  double returned = 0.0;
  const DriftSettings settings = drift_settings(world);
  share_articulates(world, [&](Articulate& articulate) {
    articulate.report = {};
    pantin::project_velocities(articulate, settings, articulate.report);
  });
  for (const auto& articulate : world.articulates) {
    world.stats.projections += articulate->report.projections;
    post_work(world, articulate->report);
    returned += articulate->report.returned;
  }
  post_projection(world, before, returned);
}

}  // namespace pantin::phases
