#include "world/kick_error.hpp"

#include <algorithm>

#include "articulates/articulate.hpp"
#include "world/forces_parts.hpp"

namespace pantin {

namespace {

/// Laws that depend on velocities are left out, with all without energy beside them: they may draw noise.
bool counts_open(const Forces& f) { return f.open && !f.moving; }

Vec3 acceleration(const Forces& f, std::size_t site) {
  const Vec3 force = counts_open(f) ? f.sites.force[site] + f.sites.open_force[site] : f.sites.force[site];
  return force * f.inverse_mass[site];
}

Vec3 force(const Forces& f, const Mover& m) { return counts_open(f) ? m.force + m.open_force : m.force; }
Vec3 torque(const Forces& f, const Mover& m) { return counts_open(f) ? m.torque + m.open_torque : m.torque; }

/// Root mean square distance of the sites from their centre [m].
double spread_of(const Sites& s) {
  if (s.n == 0) return 0.0;
  Vec3 sum = zero3();
  double square = 0.0;
  for (std::size_t i = 0; i < s.n; i++) {
    const Vec3 d = s.x[i] - s.x[0];
    sum += d;
    square += norm2(d);
  }
  const double n = static_cast<double>(s.n), spread = square / n - norm2(sum / n);
  return spread > 0.0 ? std::sqrt(spread) : 0.0;
}

/// Twice the largest spread of the sites until now, which an oscillator's is too while it passes its anchor, over the cubic
/// root of their number, or that of the volume of a periodic box for each [m].
double spacing(const World& world, const Forces& f) {
  const double count = std::cbrt(static_cast<double>(f.sites.n));
  if (const auto& box = world.settings.box) return std::cbrt((*box)[0] * (*box)[1] * (*box)[2]) / count;
  const double spread = std::max(f.spread, spread_of(f.sites));
  return spread > 0.0 ? 2.0 * spread / count : 1.0;
}

/// Linear acceleration, and that of the far end of a body by its torque [m/s²].
double change(const World& world, const Forces& f, const Mover& m) {
  const double pull = norm(force(f, m) - m.noted_force);
  if (!m.is_body) return pull / world.points.at_slot(m.slot).mass;
  const Motion& motion = world.motion[m.slot];
  const double extent = std::sqrt(largest(motion.inertia) / motion.mass);
  const double turning = norm(torque(f, m) - m.noted_torque);
  return (pull + (extent > 0.0 ? turning / extent : 0.0)) / motion.mass;
}

}  // namespace

void note_kicks(World& world) {
  if (!world.forces) return;
  Forces& f = *world.forces;
  if (!world.settings.box) f.spread = std::max(f.spread, spread_of(f.sites));
  f.noted.resize(world.points.slots());
  for (std::size_t i = 0; i < f.sites.n; i++)
    if (f.point[i] != Forces::none) f.noted[f.point[i]] = acceleration(f, i);
  for (Mover& m : f.movers) {
    m.noted_force = force(f, m);
    m.noted_torque = torque(f, m);
  }
}

double kick_error(const World& world) {
  if (!world.forces) return 0.0;
  const Forces& f = *world.forces;
  double worst = 0.0;
  for (std::size_t i = 0; i < f.sites.n; i++)
    if (f.point[i] != Forces::none) worst = std::max(worst, norm(acceleration(f, i) - f.noted[f.point[i]]));
  const double space = spacing(world, f);
  worst /= space;
  for (const Mover& m : f.movers) {
    const double length = m.articulate < 0 ? space : world.articulates[static_cast<std::size_t>(m.articulate)]->length;
    worst = std::max(worst, change(world, f, m) / length);
  }
  return worst * world.part.h / 6.0;
}

double coming_kick_error(World& world) {
  Forces& f = *world.forces;
  note_kicks(world);
  read_velocities(world, f, false);
  const auto places = f.sites.x, force = f.sites.force, open = f.sites.open_force;
  for (std::size_t i = 0; i < f.sites.n; i++) f.sites.x[i] += f.sites.v[i] * world.settings.step;
  run_still_laws(world, f, instant_of(world, world.time, world.instant), false);
  collect(world, f);
  const double rate = kick_error(world) * world.sub_steps.count;
  f.sites.x = places;
  f.sites.force = force;
  f.sites.open_force = open;
  collect(world, f);
  return std::isfinite(rate) ? rate : infinity;
}

}  // namespace pantin
