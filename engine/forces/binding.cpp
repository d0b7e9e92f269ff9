// What the sites of laws are bound to: loose points, or the bodies and tied points that move them.
#include <algorithm>

#include "articulates/articulate.hpp"
#include "forces/forces_parts.hpp"
#include "forces/integrator.hpp"

namespace pantin {

namespace {

std::uint32_t receiver_of(const World& world, Forces& f, PointId centre) {
  const BodyId body = world.points[centre].body;
  std::vector<std::uint32_t>& known = body ? f.receiver_of_body : f.receiver_of_point;
  const std::uint32_t slot = (body ? body.slot : centre.slot) - 1;
  if (known.size() <= slot) known.resize(slot + 1, Forces::none);
  if (known[slot] == Forces::none) {
    known[slot] = static_cast<std::uint32_t>(f.receivers.size());
    Receiver m;
    m.slot = slot;
    m.is_body = static_cast<bool>(body);
    f.receivers.push_back(m);
  }
  return known[slot];
}

Kin kin_of(const World& world, Forces& f, const Particle& particle) {
  std::vector<std::uint32_t>& list = f.sites.bodies_of_hinges;
  Kin kin;
  if (particle.is_hinge()) kin.begin = static_cast<std::uint32_t>(list.size());
  for (PointId p : particle.points) {
    const BodyId body = world.points[p].body;
    if (!body) continue;
    if (kin.first == 0) kin.first = body.slot;
    if (particle.is_hinge()) list.push_back(body.slot);
  }
  if (particle.is_hinge()) kin.count = static_cast<std::uint32_t>(list.size()) - kin.begin;
  return kin;
}

}  // namespace

Wanted wanted(const World& world, const Forces& f, ParticleId id) {
  const Particle& particle = world.particles[id];
  if (acts_on_all(f, particle.family)) return Wanted::by_others;
  Wanted how = Wanted::not_at_all;
  const auto look = [&](ParticleId end) {
    for (ConnectionId c : world.particles[end].connections) {
      const Connection& row = world.connections[c];
      if (row.enabled) how = std::max(how, row.solve == Solve::explicitly ? Wanted::by_others : Wanted::by_solved);
    }
  };
  look(id);
  if (particle.is_hinge())
    for (PointId p : particle.points) look(world.points[p].own);
  return how;
}

void bind_site(const World& world, Forces& f, std::uint32_t site, ParticleId id, Wanted how) {
  const Particle& particle = world.particles[id];
  Sites& s = f.sites;
  s.particle[site] = id.slot - 1;
  s.serial[site] = particle.serial;
  s.family[site] = particle.family ? particle.family.slot - 1 : Forces::none;
  s.kin[site] = kin_of(world, f, particle);
  s.force[site] = s.nonconservative_force[site] = zero3();
  f.site_of[id.slot - 1] = site;
  f.image[site] = zero3();
  f.point[site] = f.attached_of[site] = Forces::none;
  f.inverse_mass[site] = 0.0;
  const PointId centre = star(world, id);
  const Point& p = world.points[centre];
  if (!p.body && p.articulate < 0) {
    f.point[site] = centre.slot - 1;
    f.inverse_mass[site] = 1.0 / p.mass;
    return;
  }
  Attached a;
  a.site = site;
  a.arm = arm(world, centre);
  a.receiver = receiver_of(world, f, centre);
  a.pulled = how == Wanted::by_others;
  f.attached_of[site] = static_cast<std::uint32_t>(f.attached.size());
  f.attached.push_back(a);
}

void unbind_site(Forces& f, std::uint32_t site) {
  const std::uint32_t at = f.attached_of[site];
  f.point[site] = f.attached_of[site] = Forces::none;
  if (at == Forces::none) return;
  f.attached[at] = f.attached.back();
  f.attached_of[f.attached[at].site] = at;
  f.attached_of[site] = Forces::none;
  f.attached.pop_back();
}

void number_attached(Forces& f) {
  f.attached_of.assign(f.sites.n, Forces::none);
  for (std::size_t k = 0; k < f.attached.size(); k++) f.attached_of[f.attached[k].site] = static_cast<std::uint32_t>(k);
}

namespace {

/// Takes out receivers to which nothing is bound any more; the last take their places.
void drop_receivers(Forces& f) {
  std::vector<std::uint32_t> now(f.receivers.size(), Forces::none), unused;
  for (const Attached& a : f.attached) now[a.receiver] = a.receiver;
  const auto known = [&](const Receiver& m) -> std::uint32_t& {
    return (m.is_body ? f.receiver_of_body : f.receiver_of_point)[m.slot];
  };
  for (std::uint32_t k = 0; k < now.size(); k++) {
    if (now[k] != Forces::none) continue;
    unused.push_back(k);
    known(f.receivers[k]) = Forces::none;
  }
  if (unused.empty()) return;
  std::size_t size = f.receivers.size();
  for (std::size_t hole = 0, holes = unused.size(); hole < holes;) {
    if (unused[holes - 1] == --size) {
      holes--;
      continue;
    }
    const std::uint32_t to = unused[hole++];
    f.receivers[to] = f.receivers[size];
    now[size] = known(f.receivers[to]) = to;
  }
  f.receivers.resize(size);
  for (Attached& a : f.attached) a.receiver = now[a.receiver];
}

/// Leaves out the bodies of hinges that were, once they are most.
void compact_kin(Sites& s) {
  std::size_t used = 0;
  for (std::size_t i = 0; i < s.n; i++) used += s.kin[i].count;
  if (s.bodies_of_hinges.size() <= 2 * used + 64) return;
  std::vector<std::uint32_t> list;
  for (std::uint32_t i = 0; i < s.n; i++) {
    const std::span<const std::uint32_t> bodies = s.bodies_of(i);
    const auto begin = static_cast<std::uint32_t>(list.size());
    if (s.kin[i].count == 0) continue;
    list.insert(list.end(), bodies.begin(), bodies.end());
    s.kin[i].begin = begin;
  }
  s.bodies_of_hinges = std::move(list);
}

/// Whether some law acts on momenta in a way that rows may have to turn back: those of velocity do not.
bool pushes(const World& world, const Forces& f) {
  return any_element(f, [&](const ActingElement& a) {
    return !a.solved && (!a.law->velocity_dependent || !rule_of(world).conserves);
  });
}

}  // namespace

void find_receivers(World& world, Forces& f) {
  drop_receivers(f);
  compact_kin(f.sites);
  for (Receiver& m : f.receivers) {
    m.articulate = m.is_body ? world.motion[m.slot].articulate : world.points.at_slot(m.slot).articulate;
    if (m.articulate >= 0)
      m.node = static_cast<std::uint32_t>(m.is_body ? world.motion[m.slot].node : world.points.at_slot(m.slot).node);
    m.pulled = false;
  }
  for (const Attached& a : f.attached) f.receivers[a.receiver].pulled = f.receivers[a.receiver].pulled || a.pulled;
  for (const auto& articulate : world.articulates) articulate->pulled = false;
  const bool pushed = pushes(world, f);
  for (const Receiver& m : f.receivers)
    if (pushed && m.articulate >= 0 && m.pulled)
      world.articulates[static_cast<std::size_t>(m.articulate)]->pulled = true;
}

}  // namespace pantin
