// Particles that are born, go or are bound elsewhere, and the sites that laws see of them: what else there is stays where
// it is.
#include <algorithm>
#include <numeric>

#include "forces/forces_parts.hpp"
#include "forces/integrator.hpp"
#include "laws/draws_noise.hpp"

namespace pantin {

namespace {

/// Calls use(list) for what is kept of each site from one evaluation to the next, where it is kept.
template <class Use>
void each_kept(Forces& f, Use use) {
  for (std::vector<Vec3>* list : {&f.still, &f.undamped, &f.noise})
    if (!list->empty()) use(*list);
}

void resize(Forces& f, std::size_t n) {
  f.sites.resize(n);
  f.point.resize(n, Forces::none);
  f.attached_of.resize(n, Forces::none);
  f.inverse_mass.resize(n, 0.0);
  f.image.resize(n, zero3());
  each_kept(f, [&](std::vector<Vec3>& list) { list.resize(n, zero3()); });
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
  s.nonconservative_force[to] = s.nonconservative_force[from];
  for (auto& column : s.attributes) column[to] = column[from];
  f.point[to] = f.point[from];
  f.attached_of[to] = f.attached_of[from];
  if (f.attached_of[to] != Forces::none) f.attached[f.attached_of[to]].site = to;
  f.inverse_mass[to] = f.inverse_mass[from];
  f.image[to] = f.image[from];
  each_kept(f, [&](std::vector<Vec3>& list) { list[to] = list[from]; });
  if (s.particle[to] != Forces::none) f.site_of[s.particle[to]] = to;
}

/// What names sites by their numbers is told the new ones: `now` of each old one, none of what is gone.
void renumber(Forces& f, const std::vector<std::uint32_t>& now) {
  for (ActingConnections& c : f.connections)
    for (std::uint32_t& site : c.bond_list.sites) site = now[site];
  for (ActingInteraction& a : f.interactions)
    if (!f.elsewhere) a.bonded = renumbered(a.bonded, now, f.sites.n);
}

bool are_named(const Forces& f) {
  const auto excludes = [](const ActingInteraction& a) { return !a.bonded.begin.empty(); };
  return !f.connections.empty() || std::any_of(f.interactions.begin(), f.interactions.end(), excludes);
}

/// Those that live, once each, in the order of making.
std::vector<ParticleId> living(const World& world, std::vector<ParticleId> list) {
  std::erase_if(list, [&](ParticleId id) { return !world.particles.alive(id); });
  const auto serial = [&](ParticleId id) { return world.particles[id].serial; };
  std::sort(list.begin(), list.end(), [&](ParticleId a, ParticleId b) { return serial(a) < serial(b); });
  list.erase(std::unique(list.begin(), list.end()), list.end());
  return list;
}

struct Member {
  ParticleId id;
  Wanted how;
};

/// Who is to have a site, and who is to be bound anew; sites that nobody wants any more go to those that are gone.
struct Turnover {
  std::vector<Member> born, kept;

  Turnover(const World& world, Forces& f, const std::vector<ParticleId>& changed) {
    for (ParticleId id : changed) {
      const Wanted how = world.particles[id].asleep_in ? Wanted::not_at_all : wanted(world, f, id);
      std::uint32_t& site = f.site_of[id.slot - 1];
      if (how != Wanted::not_at_all) {
        (site == Forces::none ? born : kept).push_back({id, how});
      } else if (site != Forces::none) {
        f.gone.push_back(site);
        site = Forces::none;
      }
    }
  }
};

/// The newborn take the places of the gone, then new ones; what places are left the last sites take. Gives the sites of
/// the newborn.
std::vector<std::uint32_t> replace(const World& world, Forces& f, const std::vector<Member>& born) {
  const std::size_t before = f.sites.n, kept = before - f.gone.size(), after = kept + born.size();
  std::vector<std::uint32_t> now(are_named(f) ? before : 0);
  std::iota(now.begin(), now.end(), 0u);
  if (!now.empty())
    for (std::uint32_t site : f.gone) now[site] = Forces::none;
  if (after > before) resize(f, after);
  std::vector<std::uint32_t> fresh;
  for (std::size_t k = 0; k < born.size(); k++) {
    fresh.push_back(k < f.gone.size() ? f.gone[k] : static_cast<std::uint32_t>(before + k - f.gone.size()));
    each_kept(f, [&](std::vector<Vec3>& list) { list[fresh.back()] = zero3(); });
    bind_site(world, f, fresh.back(), born[k].id, born[k].how);
  }
  auto last = static_cast<std::uint32_t>(before);
  for (std::size_t hole = born.size(), holes = f.gone.size(); hole < holes;) {
    if (--last == f.gone[holes - 1]) {
      holes--;
      continue;
    }
    if (!now.empty()) now[last] = f.gone[hole];
    move(f, last, f.gone[hole++]);
  }
  if (after < before) resize(f, after);
  if (!now.empty() && !(f.gone.empty() && born.empty())) renumber(f, now);
  return fresh;
}

/// Connections at the particles, which may tie other sites now.
std::vector<ConnectionId> connections_at(const World& world, const std::vector<ParticleId>& particles) {
  std::vector<ConnectionId> list;
  for (ParticleId id : particles)
    list.insert(list.end(), world.particles[id].connections.begin(), world.particles[id].connections.end());
  const auto serial = [&](ConnectionId id) { return world.connections[id].serial; };
  std::sort(list.begin(), list.end(), [&](ConnectionId a, ConnectionId b) { return serial(a) < serial(b); });
  list.erase(std::unique(list.begin(), list.end()), list.end());
  return list;
}

}  // namespace

bool can_change_members(const World& world, const Forces& f) {
  if (f.elsewhere && f.grouped) return false;
  const auto ends_at_position = [&](ConnectionId id) { return !world.connections[id].positions.empty(); };
  for (ParticleId id : f.changed) {
    if (!world.particles.alive(id)) continue;
    const std::vector<ConnectionId>& list = world.particles[id].connections;
    if (std::any_of(list.begin(), list.end(), ends_at_position)) return false;
  }
  return true;
}

std::vector<std::uint32_t> change_members(const World& world, Forces& f) {
  f.velocity.known = false;
  const std::vector<ParticleId> changed = living(world, std::move(f.changed));
  f.site_of.resize(world.particles.slots(), Forces::none);
  const Turnover turnover(world, f, changed);
  std::sort(f.gone.begin(), f.gone.end());
  for (std::uint32_t site : f.gone) unbind_site(f, site);
  std::vector<std::uint32_t> fresh = replace(world, f, turnover.born);
  for (const Member& m : turnover.kept) {
    const std::uint32_t site = f.site_of[m.id.slot - 1];
    unbind_site(f, site);
    bind_site(world, f, site, m.id, m.how);
    fresh.push_back(site);
  }
  std::sort(fresh.begin(), fresh.end());
  change_bonds(world, f, connections_at(world, changed));
  for (ActingInteraction& a : f.interactions)
    if (f.elsewhere) a.bonded = bonded(f, a.law->exclude);
  f.changed.clear();
  f.gone.clear();
  f.unsettled = f.elsewhere = false;
  fill_attributes(world, f, fresh);
  check_attributes(world, f, fresh);
  return fresh;
}

bool are_apart(const World& world, const Forces& f) {
  const auto follows = [](char followed) { return followed != 0; };
  const bool solved_in_kicks = rule_of(world).kicks && !f.nonconservative_still;
  return !f.elsewhere && f.interactions.empty() && (!f.velocity_dependent || solved_in_kicks) && !f.grouped &&
         std::none_of(f.followed.begin(), f.followed.end(), follows) &&
         std::find(f.sites.names.begin(), f.sites.names.end(), "age") == f.sites.names.end();
}

namespace {

/// Adds the forces of the fields on some sites, in rising order, and their energy times the sign to what is known of it.
double run_fields(const World& world, Forces& f, std::span<const std::uint32_t> some, double sign) {
  double energy = 0.0;
  for (ActingField& a : f.fields) {
    a.fields.arrange(a.sites_of(world, f, 0, some));
    const double part = run_law(world, f, a, instant_of(world, world.time, world.instant), true);
    a.energy += sign * part;
    energy += sign * part;
  }
  return energy;
}

/// What of the forces of fields on some sites is noise, where errors are to be told without it.
void find_noise_on(const World& world, Forces& f, std::span<const std::uint32_t> some) {
  if (!world.settings.accuracy || !f.noisy) return;
  f.noise.resize(f.sites.n, zero3());
  for (std::uint32_t site : some) f.noise[site] = zero3();
  const KeptForces kept(f.sites);
  Instant instant = instant_of(world, world.time, world.instant);
  for (const bool silent : {false, true}) {
    instant.silent = silent;
    std::fill(f.sites.nonconservative_force.begin(), f.sites.nonconservative_force.end(), zero3());
    for (ActingField& a : f.fields)
      if (draws_noise(*a.law) && !a.law->thermal) run_law(world, f, a, instant);
    for (std::uint32_t site : some) f.noise[site] += f.sites.nonconservative_force[site] * (silent ? -1.0 : 1.0);
  }
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
  find_noise_on(world, f, fresh);
  keep_in_plane(world.plane, f.sites);
  arrange(world, f);
  return change;
}

}  // namespace pantin
