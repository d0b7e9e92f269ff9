#include <algorithm>
#include <initializer_list>

#include "articulates/articulate.hpp"
#include "forces/forces.hpp"
#include "snapshot/check_read.hpp"

namespace pantin {

namespace {

void sound_forces(bool good) { require(good, "what laws act on contradicts itself in it"); }

/// Each is an index below `size`, or none.
bool all_known(const std::vector<std::uint32_t>& list, std::size_t size) {
  return std::all_of(list.begin(), list.end(), [&](std::uint32_t i) { return i == Forces::none || i < size; });
}

void check_sites(const Sites& s, const World& world) {
  const std::size_t padded = s.n + Sites::padding;
  sound_forces(s.n < s.x.size() && s.x.size() == padded && s.v.size() == padded && s.force.size() == padded &&
               s.nonconservative_force.size() == padded && s.particle.size() >= s.n && s.serial.size() >= s.n &&
               s.family.size() >= s.n && s.kin.size() >= s.n && s.names.size() == s.attributes.size());
  for (const auto& column : s.attributes) sound_forces(column.size() == padded);
  sound_forces(all_known(s.particle, world.particles.slots()));
  for (std::size_t i = 0; i < s.n; i++)
    sound_forces(s.kin[i].begin <= s.bodies_of_hinges.size() &&
                 s.kin[i].count <= s.bodies_of_hinges.size() - s.kin[i].begin);
}

void check_receivers(const Forces& f, const World& world) {
  for (const Receiver& r : f.receivers) {
    sound_forces(r.slot < (r.is_body ? world.bodies.slots() : world.points.slots()));
    sound_forces(r.articulate == -1 ||
                 (r.articulate >= 0 && static_cast<std::size_t>(r.articulate) < world.articulates.size() &&
                  r.node < world.articulates[static_cast<std::size_t>(r.articulate)]->nodes.size()));
  }
  for (const Attached& a : f.attached) sound_forces(a.site < f.sites.n && a.receiver < f.receivers.size());
}

void check_bonds(const ActingConnections& a, std::size_t sites) {
  const BondList& list = a.bond_list;
  sound_forces(list.count == a.law->count && a.ids.size() == a.serials.size() &&
               list.sites.size() == a.ids.size() * static_cast<std::size_t>(list.count));
  sound_forces(std::all_of(list.sites.begin(), list.sites.end(), [&](std::uint32_t site) { return site < sites; }));
  sound_forces(list.parameters.empty() || list.parameters.size() == a.law->parameters.size());
  for (const std::vector<double>& column : list.parameters) sound_forces(column.size() == a.ids.size());
}

/// A law that acts for a row has the parameters of that row's own.
template <class Acting, class Rows>
void check_row(const Acting& a, const Rows& rows) {
  sound_forces(a.law && (!rows.alive(a.id) || rows[a.id].parameters.size() == a.law->parameters.size()));
}

void check_exclusions(const Exclusions& e, std::size_t sites) {
  if (e.begin.empty()) return;
  sound_forces(e.begin.size() == sites + 1 && std::is_sorted(e.begin.begin(), e.begin.end()) &&
               e.begin.back() <= e.list.size());
}

void check_velocities(const VelocityForces& v, std::size_t sites) {
  for (const VelocityPair& pair : v.pairs) sound_forces(pair.a < sites && pair.b < sites);
  for (const auto& listed : v.listed) sound_forces(listed.begin <= listed.end && listed.end <= v.pairs.size());
  for (const SiteSlopes* slopes : {&v.fields, &v.workless})
    sound_forces(slopes->force.size() == slopes->slope.size() &&
                 (slopes->force.size() == 0 || slopes->force.size() >= sites));
  for (const auto* list : {&v.at, &v.at_rest}) sound_forces(list->size() == 0 || list->size() >= sites);
}

/// None, or one for each and some more.
void check_sizes(std::size_t least, std::initializer_list<std::size_t> sizes) {
  for (const std::size_t size : sizes) sound_forces(size == 0 || size >= least);
}

void check_notes(const KickNotes& notes, const World& world) {
  check_sizes(world.particles.slots(),
              {notes.acceleration.size(), notes.position.size(), notes.within.size(), notes.jerk.size(),
               notes.kept_jerk.size(), notes.untold.size(), notes.kept_untold.size(), notes.swing.size(),
               notes.kept_swing.size(), notes.partner.size()});
  sound_forces(all_known(notes.partner, world.particles.slots()));
}

}  // namespace

void check_read(const Forces& f, const World& world) {
  const std::size_t n = f.sites.n;
  check_sites(f.sites, world);
  check_receivers(f, world);
  sound_forces(all_known(f.point, world.points.slots()) && all_known(f.site_of, n) &&
               all_known(f.receiver_of_body, f.receivers.size()) &&
               all_known(f.receiver_of_point, f.receivers.size()) && all_known(f.attached_of, f.attached.size()));
  sound_forces(f.point.size() >= n && f.inverse_mass.size() >= n && f.attached_of.size() >= n &&
               f.site_of.size() <= world.particles.slots() && f.receiver_of_body.size() <= world.bodies.slots() &&
               f.receiver_of_point.size() <= world.points.slots());
  for (const ActingInteraction& a : f.interactions) check_exclusions(a.bonded, n), check_row(a, world.interactions);
  for (const ActingField& a : f.fields) check_row(a, world.fields);
  for (const ActingConnections& a : f.connections) check_bonds(a, n);
  for (const std::uint32_t site : f.gone) sound_forces(site < n);
  check_sizes(n, {f.image.size(), f.still.size(), f.undamped.size(), f.noise.size(), f.kicked_from.size(),
                  f.notes.change.size(), f.notes.moved.size(), f.notes.turning.size(), f.notes.near.size()});
  check_velocities(f.velocity, n);
  check_velocities(f.thermostats, n);
  check_notes(f.notes, world);
}

}  // namespace pantin
