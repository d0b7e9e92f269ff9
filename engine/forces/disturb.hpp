#pragma once
// What edits tell the laws at work.
#include "world/world.hpp"

namespace pantin::internal {

/// Call before an edit that changes which laws act, or on what: the energy of the laws before the edit leaves the balance,
/// and comes back with the forces of the next step. What else is called "disturb" does the same, before other edits.
void disturb_forces(World& world);
/// What bodies and points are, where they are, and what is tied: what is edited is looked at anew, all else stays as it is.
void disturb_sites(World& world);
/// What laws see of one particle.
void disturb_site(World& world, ParticleId particle);
/// Velocities.
void disturb_forces_by_motion(World& world);
/// A free particle of a family, or of none, is made, after which `note_site` is to be called.
void disturb_forces_by_birth(World& world, FamilyId family);
void note_site(World& world, ParticleId particle);
/// A particle is removed.
void disturb_forces_by_death(World& world, ParticleId particle);
/// A connection is removed.
void disturb_forces_by_break(World& world, const Connection& connection);
/// Of what edits concerned.
void note_edited_sites(World& world);
}  // namespace pantin::internal
