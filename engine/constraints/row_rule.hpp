#pragma once
// What each kind of row asks for. A kind is one file that fills one RowRule: what it is to the solver, the residual of the row
// at the end of a step with its derivative, its part in the velocity projection, and the gap that the fallback step closes.
// How to add one: assets/pages/adding.md.
#include "constraints/row.hpp"

namespace pantin {

struct RowContext {
  double h;         ///< [s]
  double mobility;  ///< [1/kg] of the row, from masses, inertia and arms alone: how far a force moves it

  /// [m/N] κ: how far a force moves the row in the step.
  double kappa() const { return 0.5 * h * h * mobility; }
};

/// [m/N] The length as which a force [N] counts that a row should not have: what it moves, or the work that it does on a
/// `displacement` [m] as a part of that of all the row's `force` [N].
inline double length_per_force(double force, double displacement, double kappa) {
  return std::fmax(kappa, displacement / std::fmax(force, 1e-3 * displacement / kappa));
}

/// The nearer end of a row's range.
struct Stop {
  Vec3 inward;             ///< unit vector: how a force of the row may act
  double room = infinity;  ///< [m] to the end; below 0 it is passed
};

/// Of the two nodes of an angular row, at the end of a step; the world is not turned.
struct Orientations {
  Quat first, second;
  const Mat3& R;  ///< of the first

  /// Rotation of the first against where the second would have it by `turn`, in the first's principal axes.
  Quat violation(const Quat& turn) const { return conjugate(second * turn) * first; }
};

/// What is left out is not so, or nothing.
struct RowRule {
  bool soft = false;              ///< forbids no motion, and only pulls
  bool by_law = false;            ///< pulls by the law of a connection: no constraint made it
  bool coupled = false;           ///< its value is one of several that add up, evaluated together by its articulate
  bool about_axis = false;        ///< an angular one about its axis alone; where it has no range a motor
  bool at_distance = false;       ///< pulls at points that are apart, in any direction, and so may turn what is free
  bool keeps_separation = false;  ///< d1 between two points is to be `position1`: what is left of a join's separation
  bool held_at_end = false;       ///< `held` says that an end of its range holds it, besides what it forbids within
  bool guides = false;  ///< its point slides along something of the world: no rigid motion has a momentum that stays
  bool leaves_turn = false;        ///< an angular one that, to the world, leaves the turn about its axis free
  bool forbids_as_newton = false;  ///< Newton's matrix forbids the velocities that projections do
  bool offsets_gap = false;        ///< a gap that cannot be closed is its offset; else it changes what it keeps
  /// Of an angular row: sets d1, or the angle, at the end of the step.
  void (*read_turn)(Row& row, Condition& condition, const Orientations& orientations) = [](Row&, Condition&,
                                                                                           const Orientations&) {};
  /// Sets residual, M and C from d0, d1 and f; returns the size of the residual in metres. Not asked of rigid rows.
  double (*evaluate)(Row& row, Condition& condition, const RowContext& context) = nullptr;
  /// Sets `kept`, and adds to `wanted` what changes by prescription; of a row with a range or a limit of its force as it does
  /// where it `holds` or not.
  void (*project)(const Row& row, Condition& condition, bool holds) = [](const Row&, Condition&, bool) {};
  /// What is still to be closed at the end of the step, [m], as a change of d1. Not asked of rigid and coupled rows.
  Vec3 (*gap)(const Row& row, const Condition& condition) = [](const Row&, const Condition&) { return zero3(); };
  /// Of a row that stops something, at the end of the step. Not asked of coupled ones.
  Stop (*stop)(const Row& row, const Condition& condition) = [](const Row&, const Condition&) { return Stop{zero3()}; };
  /// Of a soft one that no law pulls: its force in a fallback step [N].
  Vec3 (*pull)(const Row& row, const Condition& condition, const RowContext& context) = nullptr;
};

// Those that several files name, each in the file of a kind that makes such rows: rigid_row in hinge.cpp, soft_row in
// follow.cpp, turn_row in turn.cpp.
extern const RowRule rigid_row;    ///< keeps two points together, or an orientation
extern const RowRule soft_row;     ///< draws a point to a position, or to a point, with a force up to a limit
extern const RowRule rod_row;      ///< keeps a distance, or keeps it in a range
extern const RowRule axis_row;     ///< keeps two axes together
extern const RowRule turn_row;     ///< drives the angle about an axis, or keeps it in a range
extern const RowRule coupled_row;  ///< a segment of a string, a turn of a gear
extern const RowRule stiff_row;    ///< pulls by a law
extern const RowRule plane_row;    ///< keeps a point on a plane
extern const RowRule path_row;     ///< keeps a point on a path
extern const RowRule align_row;    ///< keeps an angle between two axes
extern const RowRule attract_row;  ///< draws two points together

/// Whether d1 is to be `offset`, in all directions: M and `kept` are 1 and C is 0, so that products leave them out.
inline bool is_rigid(const Row& row) { return row.rule == &rigid_row; }
inline bool is_soft(const Row& row) { return row.rule->soft; }
inline bool is_coupled(const Row& row) { return row.rule->coupled; }
inline bool pulls_by_law(const Row& row) { return row.rule->by_law; }
inline bool is_motor(const Row& row, const Condition& c) { return row.rule->about_axis && !c.ranged; }

/// Sets the angle by which a row is turned about its axis, turns counted.
void count_angle(Row& row, Condition& condition, const Orientations& orientations);

/// A row of one dimension reads a value, held in a range by a force along n.
struct ConstraintFunction {
  Vec3 n;                        ///< of unit length; a force along it does work on the value exactly
  Vec3 gradient;                 ///< of the value at the end of the step, by d1
  double above_low, above_high;  ///< [m] how far the value is above the ends of the range
  double turn_of_n = 0.0;        ///< [1/m] by how much n turns, across itself, with a change of d1
  double displacement = 0.0;     ///< [m] how far d moves in the step: a force across n does work on that
};
/// Sets residual, M, C and `held`; returns the size of the residual [m]. Held, the force along n is what keeps the value
/// at the end of its range; else it is 0, or the limit that it would exceed. Which, is told by where the force would go
/// to close the gap (Alart and Curnier 1991). Held to n by two more equations: n g + κ P f = 0, P = 1 - n n',
/// κ makes a force a length.
double evaluate_function(Row& row, Condition& condition, const ConstraintFunction& function, const RowContext& context);
/// Sets `kept` and `wanted` of a row that forbids velocities along `gradient`, where it holds; `slope` is by how much the
/// value changes with d along that.
void project_function(Condition& condition, Vec3 gradient, bool holds, double slope = 1.0);
/// Ends of a range, which is wider while what is outside is drawn in, [m].
inline double low_end(const Condition& c) { return c.low + std::fmin(0.0, c.kept_value); }
inline double high_end(const Condition& c) { return c.high + std::fmax(0.0, c.kept_value); }
/// Of a value along a unit vector, by how far it is above the ends of its range [m].
inline Stop nearer_end(Vec3 along, double low, double high) {
  return -high < low ? Stop{along * -1.0, -high} : Stop{along, low};
}
/// What a row misses [m], by how far its value is above the ends of its range.
double missing(const Condition& condition, double low, double high);

}  // namespace pantin
