#pragma once
// How far constraints are from what they want.
#include "world/world.hpp"

namespace pantin {

/// Distance or angle that a rod, limit, motor or align has now, [m] or [rad].
double present_length(const World& world, const Constraint& constraint);
/// Rotation vector, world axes, from where an orient or weld wants its body to where it is, [rad].
Vec3 present_turn(const World& world, const Constraint& constraint);
/// Least radius of gyration of the bodies whose rotation a constraint ties, [m]: turns an angle into a distance.
double lever(const World& world, const Constraint& constraint);
/// What a constraint misses now, but for what it still draws in, [m].
double present_gap(const World& world, const Constraint& constraint);

namespace editing {
/// A constraint starts anew: what is far from where it wants it is drawn in, a deviation within the tolerance is not
/// one. Targets have no history.
void start_constraint(const World& world, Constraint& constraint);
/// Puts a constraint into the world. Throws Error where it does not fit into the world's plane.
ConstraintId insert_constraint(World& world, Constraint constraint);
}  // namespace editing

}  // namespace pantin
