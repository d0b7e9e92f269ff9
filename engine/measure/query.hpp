#pragma once
#include <string_view>
#include <vector>

#include "world/world.hpp"

namespace pantin {

/// The oldest living thing of that name, or monostate.
AnyId find(const World& world, std::string_view name);
/// The living thing that messages call by this number, as "body 11"; null: none.
AnyId find_numbered(const World& world, std::uint64_t serial);
/// Awake particles within `radius` [m] of a position, nearest first; in a periodic box their nearest images count.
std::vector<ParticleId> near(const World& world, Vec3 at, double radius);
/// Awake particles in the order of making; of one family; hinges only.
std::vector<ParticleId> particles(const World& world);
std::vector<ParticleId> particles(const World& world, FamilyId family);
std::vector<ParticleId> hinges(const World& world);
/// Hinges that a body's points are in.
std::vector<ParticleId> hinges_of(const World& world, BodyId body);
/// Force of a hinge on one of its bodies in the last step, [N].
Vec3 hinge_force(const World& world, ParticleId hinge, BodyId body);

}  // namespace pantin
