#pragma once
#include "articulates/articulate.hpp"

namespace pantin {

/// Solves one step of h for rotations and row forces together, from predicted unknowns; its end becomes the nodes'
/// start. False where it does not converge; the starts are untouched.
bool solve_step(Articulate& articulate, double h, Vec3 gravity, DriftReport& report);

/// Finds the gaps that a solved step leaves: those of hinges alone are at hand.
void find_solved_gaps(Articulate& articulate);

/// Tells the work of world ends that move, of limited pulls, of lengths that change, of motors and limits, in the step just solved.
void add_work_of_rows(Articulate& articulate, DriftReport& report);
/// Work in the step just solved, of h [s], that is none when it is solved exactly: of forces on gaps, and of moments on
/// what rotations miss; and what round-off of the positions makes of the work of all rows. Articulate::saved: the nodes before.
void add_unsolved_work(const Articulate& articulate, double h, DriftReport& report);

/// Sets r and d of all rows at the start, from the nodes' starts and `position0`.
void place_rows_at_start(Articulate& articulate);
/// The same at the end, from the nodes' ends and `position1`.
void place_rows_at_end(Articulate& articulate);

/// Where in the step the row forces act: at the arms of its start (Euler), the mean of both ends (the
/// midpoint step), or its end (projections).
enum class Arms : std::uint8_t { start, mean, end };
/// The rows' matrix and right side: left arms at the end, right arms as told, M and C of the rows (`scale` C is added),
/// compliance `epsilon` relative to the diagonal. Nodes turn by R I⁻¹ R' of the start or end, or, with arms at the mean of
/// a step of `h`, as Newton's matrix says. The right side is `right_scale` times the residual, with Newton's matrix also
/// what the nodes' own residuals move.
struct System {
  Arms right;
  double epsilon, scale, right_scale, h = 0.0;
  bool turns = true;  ///< nodes may turn; else they are only shifted
};
/// Fills and factorises the matrix and takes its right side through the first half of the solution, whose second half is
/// `Factor::substitute_back`. Returns whether a pivot is weak.
bool factorise(Articulate& articulate, const System& system);
/// Call before a right side is taken through the first half of a solution, and at the beginning of the second half.
void clear_hubs(Articulate& articulate);
void solve_hubs(Articulate& articulate);
/// The same for another right side on the factor of Newton's matrix at hand.
void reuse_factor(Articulate& articulate, const System& system);
/// R I⁻¹ R' with the rotation at the start or end of the step.
Mat3 inverse_inertia(const Node& node, const Mat3& R);

/// tr(S_kk)/3 of a row from the nodes' masses and inverse inertia, of a turn along its axes, [1/kg].
double mobility(const Articulate& articulate, const Row& row);

}  // namespace pantin
