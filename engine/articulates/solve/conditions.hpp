#pragma once
// Between constraints and the rows they make.
#include <vector>

#include "articulates/articulate.hpp"

namespace pantin {

/// A row that a constraint wants, and which of its things and positions it ties; null b: the world.
struct RowPlan {
  RowKind kind = RowKind::rigid;
  bool angular = false;
  PointId point_a, point_b;
  BodyId body_a, body_b;                  // where no points are given
  Vec3 arm_a = zero3(), arm_b = zero3();  // [m] or axis, in the frame of a body
  std::uint32_t index = 0;
};
std::vector<RowPlan> plan_rows(const Model& model, const Constraint& constraint);

/// What the step needs to know of a constraint; `total_mass` of the articulate [kg].
void load(Condition& condition, const Row& row, const Model& model, double total_mass);
/// What the step found out; `force` of the row [N].
void store(const Condition& condition, const Row& row, Vec3 force, Constraint& constraint);
/// Inertia of all nodes about a position, as if they were one, [kg m²].
double inertia_about(const Articulate& articulate, Vec3 position);
/// Limits are stronger than motors, and all else than motors of limited torque: where a step of h [s] cannot be solved,
/// motors yield by the step's way to what would stop them; until they give less than half of it, or are driven back. False
/// where that changes nothing.
bool stall_motors(Articulate& articulate, double h);
/// Motors of limited torque that stall exert ten times as much in each step of h [s], up to what they can.
void strengthen_stalled(Articulate& articulate, double h);
/// What a motor by speed wants at a moment `at` (0 … 1) of the step, [m/s].
double speed(const Condition& condition, double at);
/// Sets what is prescribed for the part from … to (0 … 1) of a step of h [s].
void set_conditions(Articulate& articulate, double h, double from, double to);

}  // namespace pantin
