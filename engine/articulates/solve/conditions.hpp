#pragma once
// What is prescribed for a part of a step, and motors that stall.
#include <vector>

#include "articulates/articulate.hpp"

namespace pantin {

/// Inertia of all nodes about a position, as if they were one, [kg m²].
double inertia_about(const Articulate& articulate, Vec3 position);
/// Limits are stronger than motors, and all else than motors of limited torque: where a step of `step` [s] cannot be solved,
/// motors may miss their targets by as far as they were to move in it; until they give less than half of `stall_force`, or are driven
/// back. False
/// where that changes nothing.
bool stall_motors(Articulate& articulate, double step);
/// Motors of limited torque that stall exert ten times as much in each full sub-step, up to what they can; `step` [s] is the
/// scene's step.
void strengthen_stalled(Articulate& articulate, double step);
/// What a motor by speed wants at a moment `at` (0 … 1) of the step, [m/s].
double speed(const Condition& condition, double at);
/// Whether an orientation that is prescribed turns in the step, and by what vector of rotation [rad].
bool is_turned(const Condition& condition);
Vec3 turn_in_step(const Condition& condition);
/// Sets what is prescribed for the part from … to (0 … 1) of a step of `step` [s].
void set_conditions(Articulate& articulate, double step, double from, double to);

}  // namespace pantin
