#pragma once
// What events wait for: something measured that gets above or below a limit.
#include <vector>

#include "base/lanes.hpp"
#include "world/world.hpp"

namespace pantin {

/// temperature [K] and energy [J] of things or of the whole scene; force [N] of a hinge (the largest on a member), a
/// constraint or a connection (its tension), in the last step; distance [m] of two things or positions; count of the
/// living members of a group, or of the particles of a family.
enum class Quantity : std::uint8_t { temperature, energy, force, distance, count };

/// A thing, or a position of the world [m] where that is monostate.
struct Whereabouts {
  AnyId thing;
  Vec3 position = zero3();
};

/// Measures a quantity of a world.
struct MeasureOf {
  const World* world = nullptr;
  Quantity quantity = Quantity::energy;
  std::vector<Whereabouts> of;
  double operator()() const;
};

/// What measures a quantity of `of`: none for the whole scene, two for a distance, else one. Throws Error where that
/// cannot be measured.
Measured measured(const World& world, Quantity quantity, const std::vector<Whereabouts>& of);

/// Throws Error where its numbers are bad.
void check(const World& world, const Measured& condition);
/// Whether a thing can be measured: an empty group too.
bool still_there(const World& world, const AnyId& thing);
/// Measures the condition of an event; whether it holds now, and did not before. It looks and answers: the world is
/// locked meanwhile.
bool begins_to_hold(World& world, EventId event);

}  // namespace pantin
