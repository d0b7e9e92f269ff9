#pragma once
// Between constraints and the rows that they make: what a step needs to know, and what it found out.
#include "constraints/row.hpp"
#include "model/model.hpp"

namespace pantin {

/// What the step needs to know of a constraint; `total_mass` of the articulate [kg].
void load(Condition& condition, const Row& row, const Model& model, double total_mass);
/// What the step found out; `force` of the row [N].
void store(const Condition& condition, const Row& row, const Model& model, Vec3 force, Constraint& constraint);

/// Of an axis that is attracted to another one: the second turns. Nothing where the row is of another kind.
void load_axis(Condition& condition, const Row& row, const Model& model, const Constraint& constraint);

}  // namespace pantin
