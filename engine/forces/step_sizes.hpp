#pragma once
// What the local error of a step is relative to.
#include "world/world.hpp"

namespace pantin {

struct Forces;

/// Finds for each particle which of those that it interacts with is nearest.
void find_partners(World& world, Forces& forces);
/// How stiffly an acceleration changes with the way that is gone along this change [1/s²]; 0 where it does not.
double stiffness_along(Vec3 change, Vec3 moved);
/// How far what moves [m] in h [s] swings by a force of that stiffness [m].
double swing_by(double stiffness, Vec3 change, Vec3 moved, double h);

}  // namespace pantin
