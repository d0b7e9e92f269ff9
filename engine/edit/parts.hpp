#pragma once
// What bodies and particles that become others share. Not for use outside world/.
#include <limits>
#include <span>

#include "edit/common.hpp"

namespace pantin::internal {

constexpr double round_off = 8.0 * std::numeric_limits<double>::epsilon();  ///< of a position, relative

/// What is kept when things become others.
struct Totals {
  double mass = 0.0;       ///< [kg]
  Vec3 centre = zero3();   ///< [m]
  Vec3 p = zero3();        ///< [kg m/s]
  Vec3 angular = zero3();  ///< [kg m²/s] about the centre
};
Totals totals_of(const World& world, std::span<const BodyId> bodies, std::span<const PointId> free_points);
/// Gives a body just weighed a momentum, and an angular momentum [kg m²/s] about its centre, in world axes.
void set_momenta(World& world, BodyId body, Vec3 p, Vec3 angular);
/// Ends what ties points of one body to each other: constraints between two of them; hinges lose all but one.
void part_ties_within(World& world, std::span<const PointId> points, const std::string& who);
/// A body at a position and orientation of its frame, of points that have no other; not weighed yet.
BodyId make_body(World& world, std::string name, Vec3 origin, const Quat& frame, std::vector<PointId> points);
/// Ends what ties the rotation of a body; the others of its hinges keep their axes.
void drop_rotations(World& world, BodyId body);
/// Takes a body that has no points any more out of the world.
void erase_body(World& world, BodyId body, const std::string& who);

}  // namespace pantin::internal
