#include "step/ledger_posts.hpp"

#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "articulates/solve/state.hpp"
#include "forces/forces.hpp"
#include "forces/integrator.hpp"
#include "measure/measure.hpp"

namespace pantin {

namespace {

constexpr std::size_t number(Source source) { return static_cast<std::size_t>(source); }

double outside(const World& world) { return world.work - world.ledger.given[number(Source::law)]; }

/// All that the ledger has explained so far, [J].
double explained(const World& world) {
  const Ledger& l = world.ledger;
  return l.gravity + l.laws + outside(world) + l.given[number(Source::projection)] +
         l.given[number(Source::energy_return)] + l.given[number(Source::fallback_step)] +
         l.given[number(Source::unsolved)] + l.given[number(Source::integrator)];
}

void post_inside(World& world, Source source, double joules) {
  world.ledger.given[number(source)] += joules;
  world.ledger.posted += std::fabs(joules);
}

}  // namespace

LedgerMark ledger_mark(const World& world, bool drifted) {
  LedgerMark m;
  if (!world.ledger.kept) return m;
  const Ledger& l = world.ledger;
  m.told = outside(world) + l.laws + l.given[number(Source::projection)] + l.given[number(Source::fallback_step)] +
           l.given[number(Source::unsolved)];
  const Vec3 gravity = world.settings.gravity;
  double kicked = 0.0;  // of what falls in kicks, not in drifts
  for (std::size_t i = 0; i < world.loose_points.size(); i++) {
    const FreeMotion& free = world.free_motion[world.loose_points[i]];
    m.kinetic += 0.5 * world.loose_masses[i] * norm2(free.v);
    kicked -= world.loose_masses[i] * dot(gravity, free.x);
  }
  const auto add = [&](double kinetic, double mass, Vec3 position) {
    m.kinetic += kinetic;
    m.falling -= mass * dot(gravity, position);
    m.size += kinetic + mass * std::fabs(dot(gravity, position));
  };
  for (const std::uint32_t slot : world.loose_bodies)
    add(kinetic_energy(world.motion[slot]), world.motion[slot].mass, world.motion[slot].x);
  for (const auto& articulate : world.articulates)
    for (const Node& n : articulate->nodes) {
      if (drifted) {
        add(kinetic_energy(n), n.mass, n.x0);
      } else if (n.is_body) {
        add(kinetic_energy(world.motion[n.slot]), n.mass, world.motion[n.slot].x);
      } else {
        const FreeMotion& free = world.free_motion[n.slot];
        add(0.5 * n.mass * norm2(free.v), n.mass, free.x);
      }
    }
  m.all_falling = m.falling + kicked;
  if (!rule_of(world).kicks) m.falling = m.all_falling;
  return m;
}

void begin_ledger(World& world) {
  Ledger& l = world.ledger;
  if (!l.wanted) return;
  if (!l.kept) {
    l.kept = true;
    l.since = world.time;
    l.before = law_ledger(world).given;
    l.posted = 0.0;
  }
  const Energy now = mechanical_energy(world);
  l.kinetic = now.kinetic;
  l.potential = now.potential;
  l.explained = explained(world);
}

void post_kick(World& world, const LedgerMark& before, bool drifted) {
  if (!world.ledger.kept) return;
  const LedgerMark now = ledger_mark(world, drifted);
  post_falling(world, now.kinetic - before.kinetic - (now.told - before.told));
}

void post_report(World& world, const DriftReport& report) {
  if (!world.ledger.kept) return;
  post_inside(world, Source::projection, report.energy_projected);
  post_inside(world, Source::fallback_step, report.dissipated);
  post_inside(world, Source::unsolved, report.unsolved);
  post_inside(world, Source::integrator, report.inexact);
  post_inside(world, Source::energy_return, report.returned);
  world.ledger.round_off += report.round_off;
}

void post_drift(World& world, const LedgerMark& before) {
  if (!world.ledger.kept) return;
  const LedgerMark now = ledger_mark(world, true);
  const double fall = before.falling - now.falling;
  post_falling(world, fall);
  world.ledger.round_off += 32.0 * std::numeric_limits<double>::epsilon() * (before.size + now.size);
  if (rule_of(world).conserves) return;
  post_inside(world, Source::integrator, now.kinetic - before.kinetic - (now.told - before.told) - fall);
}

void post_solved_laws(World& world, Articulate& articulate) {
  Ledger& ledger = world.ledger;
  if (!ledger.kept) return;
  for (Condition& c : articulate.conditions) {
    if (!c.stiff) continue;
    std::shared_ptr<const Law> law = world.connections[c.stiff->connection].law;
    for (double& by_curve : c.energy_given) {
      const double given = std::exchange(by_curve, 0.0);
      ledger.laws += given;
      ledger.kicks[law->name] += given;
      ledger.posted += std::fabs(given);
      law = law->also;
    }
  }
}

void post_projection(World& world, const LedgerMark& before, double returned) {
  if (!world.ledger.kept) return;
  const LedgerMark now = ledger_mark(world, true);
  post_inside(world, Source::energy_return, returned);
  post_inside(world, Source::projection, now.kinetic - before.kinetic - (now.told - before.told) - returned);
}

void end_ledger(World& world) {
  Ledger& l = world.ledger;
  if (!l.kept) return;
  const Energy now = mechanical_energy(world);
  l.unexplained += std::fabs(now.kinetic - l.kinetic - (explained(world) - l.explained));
  l.gravity_potential += now.potential - l.potential;
}

}  // namespace pantin
