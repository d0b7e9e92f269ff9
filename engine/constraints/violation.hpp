#pragma once
// How far constraints are from what they want.
#include "model/model.hpp"

namespace pantin {

/// Distance or angle that a rod, limit, motor or align has now, [m] or [rad].
double present_length(const Model& model, const Constraint& constraint);
/// Rotation vector, world axes, from where an orient or weld wants its body to where it is, [rad].
Vec3 present_turn(const Model& model, const Constraint& constraint);
/// Least radius of gyration of the bodies whose rotation a constraint ties, [m]: turns an angle into a distance.
double lever(const Model& model, const Constraint& constraint);
/// What a constraint misses now, but for what it still draws in, [m].
double present_gap(const Model& model, const Constraint& constraint);

/// A constraint starts anew: what is far from where it wants it is drawn in, a violation within `tolerance`, relative to
/// sizes, is not one. Targets have no history.
void start_constraint(const Model& model, Constraint& constraint, double tolerance);

}  // namespace pantin
