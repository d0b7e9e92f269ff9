#pragma once
// Numbers about the whole world or a set of things.
#include <cstdint>
#include <vector>

#include "world/world.hpp"

namespace pantin {

struct Energy {
  double kinetic = 0.0;    ///< [J]
  double potential = 0.0;  ///< [J] in gravity, 0 at the world's origin
  double total() const { return kinetic + potential; }
};

/// Bodies and free points, each once; groups and hinges give what belongs to them.
struct Things {
  std::vector<BodyId> bodies;
  std::vector<PointId> free_points;
};
Things everything(const World& world);
Things things_of(const World& world, const AnyId& thing);
/// The bodies, in order and each once, and free points of particles.
Things things_of(const World& world, const std::vector<ParticleId>& list);

Energy energy(const World& world, const Things& things);
Vec3 momentum(const World& world, const Things& things);          ///< [kg m/s]
Vec3 angular_momentum(const World& world, const Things& things);  ///< [kg m²/s] about the world's origin
double mass(const World& world, const Things& things);            ///< [kg]
/// 2 E_k / (degrees of freedom · k_B) relative to the common motion, [K] (or [J] while k_B is 1). Hinges, nails and rods
/// between the things take degrees of freedom away, as far as their rows are independent by count.
double temperature(const World& world, const Things& things);

Energy energy(const World& world);
/// Kinetic, and potential in gravity alone: without the laws'.
Energy mechanical_energy(const World& world);
/// Gaps now; `energy` relative to the start. Cheap: one pass over constraints and bodies.
Accuracy accuracy(const World& world);
/// On shape a, the mean over the last step, or over its last sub-step [N].
Vec3 contact_force(const World& world, const Contact& contact);
/// The largest number of sub-steps that a body or articulate took in the last step, those of the scene's kicks included, and
/// the body, or the first of the articulate; empty where all took as many.
struct MostSubSteps {
  std::uint32_t count = 1;
  std::string thing;
};
MostSubSteps most_sub_steps(const World& world);
/// Hash of all positions and velocities in the order of making: equal states have equal hashes.
std::uint64_t state_hash(const World& world);

/// Box round all points and shapes of the things; of nothing the origin.
Bounds bounds(const World& world, const Things& things);
/// Free points and bodies of a group, sorted into clusters in which each is within `distance` [m] of another (positions of
/// free points, centres of bodies; in a periodic box their nearest images), biggest first.
std::vector<std::vector<AnyId>> clusters(const World& world, GroupId group, double distance);

}  // namespace pantin
