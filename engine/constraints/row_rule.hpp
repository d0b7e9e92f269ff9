#pragma once
// What each kind of row asks for. A kind is one file that fills one entry of the table: the residual of the row at the
// end of a step with its derivative, its part in the velocity projection, and the gap that the fallback step closes.
#include <array>

#include "constraints/row.hpp"

namespace pantin {

struct RowContext {
  double h;         ///< [s]
  double mobility;  ///< [1/kg] of the row, from masses, inertia and arms alone: how far a force moves it
};

/// The nearer end of a row's range.
struct Stop {
  Vec3 inward;             ///< unit vector: how a force of the row may act
  double room = infinity;  ///< [m] to the end; below 0 it is passed
};

/// What is left out is nothing.
struct RowRule {
  bool offsets_gap = false;  ///< a gap that cannot be closed is its offset; else it changes what it keeps
  /// Sets residual, M and C from d0, d1 and f; returns the size of the residual in metres.
  double (*evaluate)(Row& row, Condition& condition, const RowContext& context) = nullptr;
  /// Sets `kept`, and adds to `wanted` what changes by prescription.
  void (*project)(const Row& row, Condition& condition) = [](const Row&, Condition&) {};
  /// What is still to be closed at the end of the step, [m], as a change of d1.
  Vec3 (*gap)(const Row& row, const Condition& condition) = [](const Row&, const Condition&) { return zero3(); };
  /// Of a row that stops something, at the end of the step.
  Stop (*stop)(const Row& row, const Condition& condition) = [](const Row&, const Condition&) { return Stop{zero3()}; };
};

// Each in the file of a kind that makes such rows; a hinge's and a stiff connection's in their own.
extern const RowRule rigid_row, soft_row, rod_row, plane_row, axis_row, align_row, turn_row, coupled_row, path_row,
    stiff_row, attract_row;

/// (kinds) in the order of RowKind
extern const std::array<const RowRule*, 11> row_rules;
inline const RowRule& rule(const Row& row) { return *row_rules[static_cast<std::size_t>(row.kind)]; }

/// A row of one dimension reads a value, held in a range by a force along n.
struct ConstraintFunction {
  Vec3 n;                     ///< of unit length; a force along it does work on the value exactly
  Vec3 gradient;              ///< of the value at the end of the step, by d1
  double low, high;           ///< [m] how far the value is above the ends of the range
  double turn_of_n = 0.0;     ///< [1/m] by how much n turns, across itself, with a change of d1
  double displacement = 0.0;  ///< [m] how far d moves in the step: a force across n does work on that
};
/// Sets residual, M, C and `held`; returns the size of the residual [m]. Held, the force along n is what keeps the value
/// at the end of its range; else it is 0, or the limit that it would exceed. Which, is told by where the force would go
/// to close the gap (Alart and Curnier 1991). Held to n by two more equations: n g + κ P f = 0, P = 1 - n n',
/// κ = (h²/2) mobility to make a force a length.
double evaluate_function(Row& row, Condition& condition, const ConstraintFunction& function, const RowContext& context);
/// Sets `kept` and `wanted` of a row that forbids velocities along `gradient`, where it is held; `slope` is by how much the
/// value changes with d along that.
void project_function(Condition& condition, Vec3 gradient, double slope = 1.0);
/// Ends of a range, which is wider while what is outside is drawn in, [m].
inline double low_end(const Condition& c) { return c.low + std::fmin(0.0, c.length); }
inline double high_end(const Condition& c) { return c.high + std::fmax(0.0, c.length); }
/// Of a value along a unit vector, by how far it is above the ends of its range [m].
inline Stop nearer_end(Vec3 along, double low, double high) {
  return -high < low ? Stop{along * -1.0, -high} : Stop{along, low};
}
/// What a row misses [m], by how far its value is above the ends of its range.
double missing(const Condition& condition, double low, double high);

}  // namespace pantin
