#pragma once
// What is done at a moment within a step, where nothing moves.
#include "articulates/articulate.hpp"

namespace pantin {

/// Puts the ends of nodes and rows where they start, at a moment `at` (0 … 1) of a step [s].
void stand_still(Articulate& articulate, double step, double at);

/// Makes velocities consistent at a moment of the step, where a row is struck or a cut step begins: a solved part turns the
/// sign of what is forbidden, which over several parts no row of one side bears. Returns what this gave beyond the work of
/// what is prescribed [J].
double make_consistent_at(Articulate& articulate, const DriftSettings& settings, double at, DriftReport& report,
                          double struck_for = 0.0);

/// The same where what it gives is returned with what the projection takes.
void begin_part_at(Articulate& articulate, const DriftSettings& settings, double at, DriftReport& report);

/// Cuts the full sub-step, and has it begin with velocities that are consistent.
void begin_cut(Articulate& articulate, const DriftSettings& settings, double at, DriftReport& report);

}  // namespace pantin
