#include "forces/disturb.hpp"

#include "forces/forces_parts.hpp"

namespace pantin {

namespace {

/// The energy of the laws leaves the balance.
void withdraw_energy(World& world) {
  Forces& f = *world.forces;
  post(world, Source::law, -(f.told ? f.energy : law_energy(world)));
  each_element(f, [&](const ActingElement& a) {
    if (a.law->has_energy()) world.given_by_laws[a.name(world)] += a.at_first - a.energy;
  });
}

void unsettle(World& world) {
  if (world.forces->unsettled) return;
  withdraw_energy(world);
  world.forces->unsettled = true;
}

}  // namespace

namespace internal {

void disturb_forces(World& world) {
  if (world.force_elements_changed) return;
  if (acting_now(world)) withdraw_energy(world);
  world.force_elements_changed = true;
}

void disturb_sites(World& world) {
  if (world.force_elements_changed || !world.forces) return;
  unsettle(world);
  world.forces->elsewhere = true;
}

void disturb_forces_by_motion(World& world) {
  if (world.forces && world.forces->velocity_dependent) disturb_sites(world);
}

void disturb_site(World& world, ParticleId particle) {
  disturb_sites(world);
  note_site(world, particle);
}

void disturb_forces_by_birth(World& world, FamilyId family) {
  if (!world.force_elements_changed && world.forces && acts_on_all(*world.forces, family)) unsettle(world);
}

void note_site(World& world, ParticleId particle) {
  if (!world.force_elements_changed && world.forces && world.forces->unsettled)
    world.forces->changed.push_back(particle);
}

void disturb_forces_by_death(World& world, ParticleId particle) {
  if (world.force_elements_changed || !world.forces) return;
  std::vector<std::uint32_t>& sites = world.forces->site_of;
  const std::uint32_t slot = particle.slot - 1;
  if (slot >= sites.size() || sites[slot] == Forces::none) return;
  unsettle(world);
  world.forces->gone.push_back(sites[slot]);
  sites[slot] = Forces::none;
}

void disturb_forces_by_break(World& world, const Connection& connection) {
  if (world.force_elements_changed || !world.forces) return;
  disturb_sites(world);
  world.forces->untied.push_back(connection.serial);
  for (ParticleId end : connection.particles)
    if (end && world.particles.alive(end)) note_site(world, awake(world, end));
}

void note_edited_sites(World& world) {
  if (world.force_elements_changed || !world.forces || !world.forces->elsewhere) return;
  const auto note = [&](PointId point) {
    const ParticleId own = world.points[point].own;
    note_site(world, own);
    if (const ParticleId ring = world.particles[own].asleep_in) note_site(world, ring);
  };
  for (const EditedThing& t : world.edited_things) {
    if (t.body && world.bodies.alive(t.body))
      for (PointId point : world.bodies[t.body].points) note(point);
    if (!t.body && world.points.alive(t.point)) note(t.point);
  }
}

}  // namespace internal

}  // namespace pantin
