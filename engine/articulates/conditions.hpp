#pragma once
// Between constraints and the rows they make.
#include <vector>

#include "articulates/articulate.hpp"

namespace pantin {

/// A row that a constraint wants, and which of its things and places it ties; null b: the world.
struct RowPlan {
  RowKind kind = RowKind::rigid;
  bool couple = false;
  PointId point_a, point_b;
  BodyId body_a, body_b;                  // where no points are given
  Vec3 arm_a = zero3(), arm_b = zero3();  // [m] or axis, in the frame of a body
  std::uint32_t part = 0;
};
std::vector<RowPlan> plan_rows(const Model& model, const Constraint& constraint);

/// What the step needs to know of a constraint; `total_mass` of the articulate [kg].
void load(Condition& condition, const Row& row, const Model& model, double total_mass);
/// What the step found out.
void store(const Condition& condition, const Row& row, Constraint& constraint);
/// Inertia of all nodes about a place, as if they were one, [kg m²].
double inertia_about(const Articulate& articulate, Vec3 place);
/// Limits are stronger than motors: where a step of h [s] cannot be solved, motors without a limit of their torque get one,
/// twice what they had and what would give all that there is their speed, and begin there; until one gives less. False
/// where that changes nothing.
bool stall_motors(Articulate& articulate, double h);
/// Sets what is prescribed for the part from … to (0 … 1) of the step.
void set_conditions(Articulate& articulate, double from, double to);

}  // namespace pantin
