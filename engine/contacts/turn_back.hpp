#pragma once
#include <span>

#include <array>
#include <cstdint>
#include <vector>

#include "contacts/bodies.hpp"
#include "contacts/passes.hpp"

namespace pantin {

/// [kg m²] World axes; 0 about an axis that it does not turn about.
Mat3 own_inertia(const BodyState& state);

/// The rigid motion that has the momentum and the angular momentum of some things, about the axes that one may have one about.
struct MotionAsOne {
  Vec3 centre = zero3();    ///< [m]
  Vec3 velocity = zero3();  ///< [m/s]
  Vec3 spin = zero3();      ///< [rad/s]

  Vec3 velocity_at(Vec3 x) const { return velocity + cross(spin, x - centre); }
};
MotionAsOne motion_as_one(const Model& model, std::span<const BodyState> states);

/// [kg m²/s] Of these things about the origin, world axes.
Vec3 angular_momentum(const Model& model, const Articulates& articulates, std::span<const std::uint32_t> things,
                      bool drifted);
/// Turns them as if they were one body, so that they have `missing` [kg m²/s] more angular momentum, and the same momentum.
/// Not about a line that they are all on, and with no
/// more energy than `most`, a part of that of their motion about their centre. Returns the work of it [J].
double turn_as_one(Model& model, const Articulates& articulates, std::span<const std::uint32_t> things, Vec3 missing,
                   bool drifted, double most = infinity);

struct TouchIsland;

/// Gives angular momentum back to all in an island that pushed each other (pairs of its bodies; -1: the world) as a turn of each
/// such group as one, so that light things between heavy ones keep theirs: `missing` (bodies) [kg m²/s]. Not to what the world
/// holds or pushed, and no more than a small part of their energy: what is light and near each other would whirl about. Returns the work of it [J].
double turn_back(Model& model, const Articulates& articulates, const TouchIsland& island, bool drifted,
                 std::span<const std::array<std::int32_t, 2>> pushed, std::span<const Vec3> missing);

}  // namespace pantin
