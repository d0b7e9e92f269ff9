#include "forces/work_check.hpp"

#include <algorithm>
#include <cmath>

#include "base/random.hpp"
#include "forces/forces_parts.hpp"
#include "forces/integrator.hpp"

namespace pantin {

namespace {

constexpr double one_in = 192.0;  // stages that are looked at
constexpr double much = 0.3;      // of the largest kinetic energy

bool is_checked(const World& world) {
  return world.forces && world.forces->nonconservative && !world.forces->noisy && rule_of(world).kicks &&
         !world.settings.box;
}

double done_by_nonconservative_laws(const World& world) {
  return world.nonconservative_work + world.ledger.given[static_cast<std::size_t>(Source::damper)];
}

/// A function of the stage alone, so that a run is repeated.
bool is_drawn(const World& world) {
  Random random{world.settings.seed, world.instant};
  return random.uniform() < 1.0 / one_in;
}

/// The part of a kick that damping leaves, as it was solved last.
double undamped_part(const Forces& f, std::size_t site) {
  const VelocityForces& k = f.velocity;
  const std::uint32_t attached = f.attached_of[site];
  const std::size_t at = attached == Forces::none ? site : f.sites.n + f.attached[attached].receiver;
  if (!f.velocity_dependent || at >= k.strength.size() || site >= k.theta.size()) return 1.0;
  const double theta = attached == Forces::none ? k.theta[site] : k.carriers[at - f.sites.n].theta;
  return 1.0 / (1.0 + theta * k.strength[at]);
}

/// What a kick over half a stage gives at most beyond half the displacement's work, h² f²/8m over what is loose [J]: what steps of
/// second order do not keep of the energy of laws that have none to tell. Of forces that do not damp.
struct Unkept {
  double spared = 0.0, kick = 0.0;  // [J] of forces that do not damp; of all, and on what is tied as if it were not
};

Unkept unkept(const World& world, const Forces& f) {
  Unkept sum;
  const double eighth = world.stage.h * world.stage.h / 8.0;  // [s²]
  for (std::size_t i = 0; i < f.sites.n; i++) {
    double mobility = f.inverse_mass[i];
    const std::uint32_t at = f.attached_of[i];
    bool tied = false;
    if (at != Forces::none) {
      const Receiver& m = f.receivers[f.attached[at].receiver];
      mobility = 1.0 / (m.is_body ? world.motion[m.slot].mass : world.points.at_slot(m.slot).mass);
      tied = m.articulate >= 0;
    }
    const Vec3 force = f.sites.nonconservative_force[i],
               spared = f.velocity_dependent && f.velocity.known ? f.undamped[i] : force;
    sum.kick += norm2(force) * mobility * eighth;
    const double part = undamped_part(f, i);
    if (!tied) sum.spared += norm2(spared) * (part * part * mobility * eighth);
  }
  return sum;
}

/// Forces of the laws without energy `at` a fraction of the displacement, of laws of velocity what they also give at rest [N] (sites).
AlignedVector<Vec3> forces_on_displacement(World& world, Forces& f, const AlignedVector<Vec3>& end,
                                           const std::vector<Vec3>& displacements, double at) {
  for (std::size_t i = 0; i < f.sites.n; i++) {
    f.sites.x[i] = end[i] - displacements[i] * (1.0 - at);
    f.sites.v[i] = zero3();
  }
  std::fill(f.sites.nonconservative_force.begin(), f.sites.nonconservative_force.end(), zero3());
  const double time = world.stage.from + at * (world.stage.to - world.stage.from);
  const Instant instant = instant_of(world, time_within(world, time), world.instant);
  each_element(f, [&](ActingElement& a) {
    if (!a.law->has_energy()) run_law(world, f, a, instant);
  });
  return f.sites.nonconservative_force;
}

}  // namespace

void note_nonconservative_forces(World& world) {
  if (!is_checked(world)) return;
  Forces& f = *world.forces;
  f.done = done_by_nonconservative_laws(world);
  const Unkept now = unkept(world, f);  // another where an edit or another step came between
  WorkCheck& check = world.work_check;
  check.unkept_at_first += now.spared - check.unkept;
  check.unkept = now.spared;
  check.kick = std::max(check.kick, now.kick);
  f.open_from.resize(world.particles.slots());
  for (std::size_t i = 0; i < f.sites.n; i++)
    if (f.sites.particle[i] != Forces::none) f.open_from[f.sites.particle[i]] = f.sites.x[i] + f.image[i];
}

void check_work(World& world) {
  if (!is_checked(world)) return;
  Forces& f = *world.forces;
  world.work_check.unkept = unkept(world, f).spared;
  const double done = std::fabs(done_by_nonconservative_laws(world) - f.done);
  const bool large = done > much * world.largest_kinetic;
  if (f.open_from.size() < world.particles.slots() || !(large || is_drawn(world))) return;
  const auto x = f.sites.x, v = f.sites.v;
  const KeptForces kept(f.sites);
  std::vector<Vec3> displacements(f.sites.n, zero3());
  for (std::size_t i = 0; i < f.sites.n; i++)
    if (f.sites.particle[i] != Forces::none) displacements[i] = x[i] + f.image[i] - f.open_from[f.sites.particle[i]];
  const auto from = forces_on_displacement(world, f, x, displacements, 0.0),
             middle = forces_on_displacement(world, f, x, displacements, 0.5),
             to = forces_on_displacement(world, f, x, displacements, 1.0);
  double missed = 0.0, all = 0.0;
  for (std::size_t i = 0; i < f.sites.n; i++) {
    if (f.sites.particle[i] == Forces::none) continue;
    const Vec3 ends = (from[i] + to[i]) * 0.5;
    missed += 2.0 / 3.0 * dot(displacements[i], middle[i] - ends);
    all += std::fabs(dot(displacements[i], ends));
  }
  f.sites.x = x;
  f.sites.v = v;
  if (!std::isfinite(missed)) return;  // of a law that has no value at rest
  const double weight = large ? 1.0 : one_in;
  WorkCheck& c = world.work_check;
  c.missed += weight * missed;
  c.squares += weight * weight * missed * missed;
  if (!large) c.drawn += weight * weight * missed * missed;
  c.sizes += weight * std::fabs(missed);
  c.done += weight * all;
}

double missed_work(const World& world) {
  const WorkCheck& c = world.work_check;
  const bool some = c.sizes > 2.0 * std::sqrt(c.drawn);  // not one stage alone that stands for many
  const bool one_sign = std::fabs(c.missed) > 4.0 * std::sqrt(c.squares), large = some && c.sizes > 0.1 * c.done;
  return (one_sign || large ? c.missed : 0.0) - (c.unkept - c.unkept_at_first);
}

}  // namespace pantin
