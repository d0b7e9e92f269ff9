#pragma once
#include "articulates/articulate.hpp"

namespace pantin {

/// Solves one step of h for rotations and row forces together, from predicted unknowns; its end becomes the nodes'
/// start. False where it does not converge; the starts are untouched.
bool solve_step(Articulate& articulate, double h, Vec3 gravity, DriftReport& report);

/// Finds the gaps that a solved step leaves: those of hinges alone are at hand.
void find_solved_gaps(Articulate& articulate);

/// Tells the work of anchors that move, of limited pulls, of lengths that change, of motors and limits, in the step just solved.
void add_work_of_rows(Articulate& articulate, DriftReport& report);
/// Work in the step just solved, of h [s], that is none when it is solved exactly: of forces on gaps, and of moments on
/// what rotations miss; and what round-off of the positions makes of the work of all rows. Articulate::saved: the nodes before.
void add_unsolved_work(const Articulate& articulate, double h, DriftReport& report);

/// Sets r and d of all rows at the start, from the nodes' starts and `position0`.
void place_rows_at_start(Articulate& articulate);
/// The same at the end, from the nodes' ends and `position1`.
void place_rows_at_end(Articulate& articulate);

}  // namespace pantin
