// Free particles that are born or go, and the sites that laws see of them: what else there is stays where it is.
#include <algorithm>
#include <numeric>

#include "world/forces_parts.hpp"

namespace pantin {

namespace {

constexpr std::uint32_t none = Forces::none;

void resize(Forces& f, std::size_t n) {
  f.sites.resize(n);
  f.point.resize(n, none);
  f.inverse_mass.resize(n, 0.0);
  f.image.resize(n, zero3());
}

void put(const World& world, Forces& f, std::uint32_t site, ParticleId id) {
  const Particle& particle = world.particles[id];
  const PointId point = particle.points[0];
  Sites& s = f.sites;
  s.particle[site] = id.slot - 1;
  s.serial[site] = particle.serial;
  s.family[site] = particle.family ? particle.family.slot - 1 : none;
  s.kin[site] = 0;
  s.force[site] = s.open_force[site] = zero3();
  f.point[site] = point.slot - 1;
  f.inverse_mass[site] = 1.0 / world.points[point].mass;
  f.image[site] = zero3();
  f.site_of[id.slot - 1] = site;
}

void move(Forces& f, std::uint32_t from, std::uint32_t to) {
  Sites& s = f.sites;
  s.x[to] = s.x[from];
  s.v[to] = s.v[from];
  s.particle[to] = s.particle[from];
  s.serial[to] = s.serial[from];
  s.family[to] = s.family[from];
  s.kin[to] = s.kin[from];
  s.force[to] = s.force[from];
  s.open_force[to] = s.open_force[from];
  for (auto& column : s.attributes) column[to] = column[from];
  f.point[to] = f.point[from];
  f.inverse_mass[to] = f.inverse_mass[from];
  f.image[to] = f.image[from];
  if (s.particle[to] != none) f.site_of[s.particle[to]] = to;
}

Exclusions renumbered(const Exclusions& old, const std::vector<std::uint32_t>& now, std::size_t n) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (std::uint32_t i = 0; i + 1 < old.begin.size(); i++)
    for (std::uint32_t j : old.of(i))
      if (now[i] != none && now[j] != none) pairs.push_back({now[i], now[j]});
  return exclusions(n, std::move(pairs));
}

/// What names sites by their numbers is told the new ones: `now` of each old one, none of what is gone.
void renumber(Forces& f, const std::vector<std::uint32_t>& now) {
  for (Attached& a : f.attached) a.site = now[a.site];
  for (ActingConnections& c : f.connections)
    for (std::uint32_t& site : c.ties.sites) site = now[site];
  f.sites.excluded = renumbered(f.sites.excluded, now, f.sites.n);
  for (ActingInteraction& a : f.interactions) a.bonded = renumbered(a.bonded, now, f.sites.n);
}

bool are_named(const Forces& f) {
  const auto excludes = [](const ActingInteraction& a) { return !a.bonded.begin.empty(); };
  return !f.attached.empty() || !f.connections.empty() || !f.sites.excluded.begin.empty() ||
         std::any_of(f.interactions.begin(), f.interactions.end(), excludes);
}

}  // namespace

std::vector<std::uint32_t> change_members(const World& world, Forces& f) {
  std::erase_if(f.born, [&](ParticleId id) { return !world.particles.alive(id); });
  std::sort(f.gone.begin(), f.gone.end());
  f.site_of.resize(world.particles.slots(), none);
  const std::size_t before = f.sites.n, kept = before - f.gone.size(), after = kept + f.born.size();
  std::vector<std::uint32_t> now(are_named(f) ? before : 0);
  std::iota(now.begin(), now.end(), 0u);
  if (!now.empty())
    for (std::uint32_t site : f.gone) now[site] = none;
  if (after > before) resize(f, after);
  // The newborn take the places of the gone, then new ones; what places are left the last sites take.
  std::vector<std::uint32_t> fresh;
  for (std::size_t k = 0; k < f.born.size(); k++) {
    fresh.push_back(k < f.gone.size() ? f.gone[k] : static_cast<std::uint32_t>(before + k - f.gone.size()));
    put(world, f, fresh.back(), f.born[k]);
  }
  auto last = static_cast<std::uint32_t>(before);
  for (std::size_t k = f.gone.size(); k-- > f.born.size();) {
    if (--last == f.gone[k]) continue;
    if (!now.empty()) now[last] = f.gone[k];
    move(f, last, f.gone[k]);
  }
  if (after < before) resize(f, after);
  if (!now.empty()) renumber(f, now);
  f.born.clear();
  f.gone.clear();
  f.unsettled = false;
  fill_attributes(world, f, fresh);
  check_attributes(world, f, fresh);
  return fresh;
}

bool are_apart(const World& world, const Forces& f) {
  const auto of_group = [&](const ActingField& acting) { return static_cast<bool>(world.fields[acting.id].group); };
  const auto follows = [](char followed) { return followed != 0; };
  return f.interactions.empty() && !(f.moving && f.open_still) &&
         std::none_of(f.fields.begin(), f.fields.end(), of_group) &&
         std::none_of(f.followed.begin(), f.followed.end(), follows) &&
         std::find(f.sites.names.begin(), f.sites.names.end(), "age") == f.sites.names.end();
}

namespace {

/// Adds the forces of the fields on some sites, in rising order, and their energy times the sign to what is known of it.
double run_fields(const World& world, Forces& f, std::span<const std::uint32_t> some, double sign) {
  double energy = 0.0;
  for (ActingField& a : f.fields) {
    const pantin::Field& row = world.fields[a.id];
    a.fields.arrange(sites_of_field(world, f, row, some));
    const double part =
        a.fields.add_forces_and_energy(f.sites, box_of(world), instant_of(world, world.time, world.instant),
                                       present_parameters(world, *a.law, row.parameters), *world.workers);
    a.energy += sign * part;
    energy += sign * part;
  }
  return energy;
}

}  // namespace

double change_members_apart(const World& world, Forces& f) {
  double change = run_fields(world, f, f.gone, -1.0);
  const std::vector<std::uint32_t> fresh = change_members(world, f);
  for (std::uint32_t site : fresh) {
    f.sites.x[site] = world.free_motion[f.point[site]].x;
    f.sites.v[site] = world.free_motion[f.point[site]].v;
  }
  change += run_fields(world, f, fresh, 1.0);
  keep_in_plane(world.plane, f.sites);
  arrange_fields(world, f);
  for (ActingConnections& c : f.connections) c.bonds.arrange(c.ties, f.sites);
  return change;
}

}  // namespace pantin
