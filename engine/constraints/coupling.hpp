#pragma once
// Couplings: several values, each with a weight, that add up to one number. Gear, rack, pulley and screw are made of them.
#include "constraints/kind.hpp"
#include "constraints/plans.hpp"

namespace pantin {

/// By how much a value counts now, in the middle of the coming step.
double weight_of(const Constraint& constraint, const CoupledValue& value);
/// What a value is now, [rad] or [m].
double value_of(const Model& model, const CoupledValue& value);
/// The sum of all, [rad] or [m].
double coupled_sum(const Model& model, const Constraint& constraint);

// What their entries in the table have in common.

/// Starts anew with the values as they are: wheels that turned while it was off mesh where they are; a rope that is too short
/// attracts what it ties.
void start_coupling(const Model& model, Constraint& constraint, double tolerance);
/// What the sum misses [m]: how far that of its things would have to move to close it which has to move least.
double coupling_gap(const Model& model, const Constraint& constraint);
/// One row for each value.
std::vector<RowPlan> coupling_rows(const Model& model, const Constraint& constraint);
/// The rows of one value, the `index`th.
void add_coupled_rows(std::vector<RowPlan>& plans, const CoupledValue& value, std::uint32_t index);
/// Of its angles, for scenes in a plane.
std::vector<PlaneNeed> axes_of_coupling(const Model& model, const Constraint& constraint);
/// After a change of the ratio, which was `before` in the middle of the last step: what was counted stays counted.
void follow_ratio(const Model& model, Constraint& constraint, double before);

/// The entry of a coupling that holds its sum from both sides, and so takes one freedom.
constexpr ConstraintRule coupling_rule(KeptNumber keeps,
                                       std::vector<PlaneNeed> (*in_plane)(const Model&, const Constraint&)) {
  ConstraintRule rule;
  rule.keeps = keeps;
  rule.freedoms = [](const Constraint&) { return FreedomsTaken{1, 1}; };
  rule.directions = no_direction;
  rule.start = start_coupling;
  rule.gap = coupling_gap;
  rule.follow = follow_ratio;
  rule.rows = coupling_rows;
  rule.in_plane = in_plane;
  return rule;
}

/// Whether the force of a row is what its constraint tells: of a pulley that of the first side, of other couplings those of the
/// first thing that turns and of what moves.
bool tells_force(const Model& model, const Condition& condition, const Row& row, const Constraint& constraint);

// See constraints/load.hpp.
void load_coupling(Condition& condition, const Row& row, const Model& model, const Constraint& constraint);
void store_coupling(const Condition& condition, const Row& row, const Model& model, Vec3 force, Constraint& constraint);

}  // namespace pantin
