#include "world/step_error.hpp"

#include <algorithm>
#include <numeric>

#include "articulates/articulate.hpp"
#include "world/encounters.hpp"
#include "world/forces_parts.hpp"

namespace pantin {

namespace {

constexpr std::uint32_t none = Forces::none;

Vec3 acceleration(const Forces& f, std::size_t site) {
  const Vec3 force = f.open ? f.sites.force[site] + f.sites.open_force[site] : f.sites.force[site];
  return force * f.inverse_mass[site];
}

/// Calls `use` with forces that are without noise.
template <class Use>
void without_noise(World& world, Forces& f, Use use) {
  const auto add = [&](double sign) {
    if (f.noise.empty()) return;
    for (std::size_t i = 0; i < f.sites.n; i++) f.sites.open_force[i] += f.noise[i] * sign;
    collect(world, f);
  };
  add(-1.0);
  use();
  add(1.0);
}

/// What interacts: sites that connections tie, and the families of interactions, each by the number of one of its sites.
std::vector<std::uint32_t> find_groups(const World& world, const Forces& f) {
  std::vector<std::uint32_t> group(f.sites.n);
  std::iota(group.begin(), group.end(), 0u);
  const auto root = [&](std::uint32_t i) {
    while (group[i] != i) i = group[i] = group[group[i]];
    return i;
  };
  const auto join = [&](std::uint32_t i, std::uint32_t j) {
    const std::uint32_t a = root(i), b = root(j);
    group[std::max(a, b)] = std::min(a, b);
  };
  for (const ActingConnections& c : f.connections)
    for (std::size_t k = 0; k < c.ties.sites.size(); k++)
      join(c.ties.sites[k], c.ties.sites[k - k % static_cast<std::size_t>(c.ties.count)]);
  for (const ActingInteraction& a : f.interactions) {
    const Interaction& row = world.interactions[a.id];
    std::uint32_t known = none;
    for (std::uint32_t i = 0; i < f.sites.n; i++)
      if (f.sites.family[i] == row.a.slot - 1 || f.sites.family[i] == row.b.slot - 1) {
        if (known == none) known = i;
        join(i, known);
      }
  }
  for (std::uint32_t i = 0; i < f.sites.n; i++) group[i] = root(i);
  return group;
}

/// Of each site: twice the root mean square distance of its group from their centre over the cubic root of their number, or
/// the edge of its share of a periodic box [m].
std::vector<double> spacings(const World& world, const Forces& f) {
  const std::size_t n = f.sites.n;
  if (const auto& box = world.settings.box)
    return std::vector<double>(n, std::cbrt((*box)[0] * (*box)[1] * (*box)[2] / static_cast<double>(n)));
  const std::vector<std::uint32_t> group = find_groups(world, f);
  std::vector<Vec3> sum(n, zero3());
  std::vector<double> square(n, 0.0), count(n, 0.0), sizes(n, 0.0);
  for (std::size_t i = 0; i < n; i++) {
    const Vec3 d = f.sites.x[i] - f.sites.x[group[i]];
    sum[group[i]] += d;
    square[group[i]] += norm2(d);
    count[group[i]]++;
  }
  for (std::size_t i = 0; i < n; i++) {
    const std::size_t g = group[i];
    const double spread = square[g] / count[g] - norm2(sum[g] / count[g]);
    sizes[i] = spread > 0.0 ? 2.0 * std::sqrt(spread) / std::cbrt(count[g]) : 0.0;
  }
  return sizes;
}

/// Of a site that moves by `way` [m] while its acceleration changes from one to another: how far it is to where that is 0.
double reach(Vec3 way, Vec3 from, Vec3 to) {
  const double change = norm(to - from);
  return change > 0.0 ? std::max(norm(from), norm(to)) * norm(way) / change : 0.0;
}

}  // namespace

namespace {

/// Now and then: the widest spacing until now, or how far the site has come since it was first seen [m].
void find_extents(World& world, Forces& f) {
  const std::size_t slots = world.particles.slots();
  f.first_place.resize(slots, vec(infinity, 0.0, 0.0));
  f.extent.resize(slots, 0.0);
  const std::vector<double> spacing = spacings(world, f);
  for (std::size_t i = 0; i < f.sites.n; i++) {
    const std::uint32_t slot = f.sites.particle[i];
    if (slot == none) continue;
    const Vec3 x = f.sites.x[i] + f.image[i];
    if (!finite(f.first_place[slot])) f.first_place[slot] = x;
    f.extent[slot] = std::max({f.extent[slot], spacing[i], norm(x - f.first_place[slot])});
  }
}

/// What the errors of a site are relative to [m]: that, or how far it has to where nothing pulls it; 1 m where all are 0.
double size_of(const Forces& f, std::size_t i) {
  const std::uint32_t slot = f.sites.particle[i];
  if (slot == none) return infinity;
  double size = f.extent[slot];
  if (f.point[i] != none)
    size = std::max(size, reach(f.sites.x[i] + f.image[i] - f.noted_place[slot], f.noted[slot], acceleration(f, i)));
  return size > 0.0 && std::isfinite(size) ? size : 1.0;
}

}  // namespace

void note_kicks(World& world) {
  if (!world.forces) return;
  Forces& f = *world.forces;
  const std::size_t slots = world.particles.slots();
  f.noted.resize(slots, zero3());
  f.noted_place.resize(slots, zero3());
  const bool due = world.part.index == 0 && world.steps % 16 == 0;  // they change slowly
  if (due || f.extent.size() < slots) find_extents(world, f);
  without_noise(world, f, [&] {
    for (std::size_t i = 0; i < f.sites.n; i++) {
      if (f.sites.particle[i] == none) continue;
      f.noted[f.sites.particle[i]] = acceleration(f, i);
      f.noted_place[f.sites.particle[i]] = f.sites.x[i] + f.image[i];
    }
    for (Mover& m : f.movers) {
      m.noted_force = m.force + m.open_force;
      m.noted_torque = m.torque + m.open_torque;
    }
  });
}

namespace {

/// Linear acceleration, and that of the far end of a body by its torque [m/s²].
double change(const World& world, const Mover& m) {
  const double pull = norm(m.force + m.open_force - m.noted_force);
  if (!m.is_body) return pull / world.points.at_slot(m.slot).mass;
  const Motion& motion = world.motion[m.slot];
  const double extent = std::sqrt(largest(motion.inertia) / motion.mass);
  const double turning = norm(m.torque + m.open_torque - m.noted_torque);
  return (pull + (extent > 0.0 ? turning / extent : 0.0)) / motion.mass;
}

}  // namespace

double kick_error(World& world) {
  if (!world.forces) return 0.0;
  Forces& f = *world.forces;
  const double factor = std::fabs(world.part.h) / 6.0;
  double worst = 0.0, fastest2 = 0.0, smallest = infinity;
  const auto see = [&](std::size_t site, double change_over_size) {
    const double rate = change_over_size * factor;
    if (rate <= worst) return;
    worst = std::isfinite(rate) ? rate : infinity;
    f.worst_site = site;
  };
  without_noise(world, f, [&] {
    for (std::size_t i = 0; i < f.sites.n; i++) {
      const std::uint32_t slot = f.sites.particle[i];
      if (slot == none) continue;
      const double extent = f.extent[slot];
      fastest2 = std::max(fastest2, norm2(f.sites.x[i] + f.image[i] - f.noted_place[slot]));
      smallest = std::min(smallest, extent);
      if (f.point[i] == none) continue;
      const double change2 = norm2(acceleration(f, i) - f.noted[slot]), least = worst / factor * extent;
      if (!(change2 <= least * least)) see(i, std::sqrt(change2) / size_of(f, i));
    }
    for (const Attached& a : f.attached) {
      const Mover& m = f.movers[a.mover];
      const double length =
          m.articulate < 0 ? size_of(f, a.site) : world.articulates[static_cast<std::size_t>(m.articulate)]->length;
      see(a.site, change(world, m) / length);
    }
  });
  for (const Encounter& met : find_encounters(world, f, std::sqrt(fastest2), smallest))
    see(met.site, met.acceleration / size_of(f, met.site));
  return worst;
}

std::string law_of_worst_error(World& world) {
  Forces& f = *world.forces;
  const auto force = f.sites.force, open = f.sites.open_force;
  const std::size_t site = std::min(f.worst_site, f.sites.n - 1);
  std::string name;
  double most = -1.0;
  each_law(world, f, [&](const std::string&, const Law&, auto& acting) {
    std::fill(f.sites.force.begin(), f.sites.force.end(), zero3());
    std::fill(f.sites.open_force.begin(), f.sites.open_force.end(), zero3());
    run_law(world, f, acting, instant_of(world, world.time, world.instant));
    const double pull = norm(f.sites.force[site] + f.sites.open_force[site]);
    if (!(pull > most)) return;
    most = pull;
    name = law_at_work(world, acting);
  });
  f.sites.force = force;
  f.sites.open_force = open;
  return name;
}

}  // namespace pantin
