#pragma once
#include "articulates/articulate.hpp"

namespace pantin {

/// What making velocities consistent gave [J].
struct EnergyOfConsistency {
  double tied = 0.0;     ///< by what ties
  double stopped = 0.0;  ///< by what stops: couplings that are taut, limits that are met
};
/// Makes the velocities of a loaded articulate consistent at a moment `at` (0 … 1) of a step of `step` [s], after an edit or where
/// its tree takes it over, unless an edit tore it apart. After an edit it is called before the first forces of the step act: what
/// they change is no edit's.
EnergyOfConsistency make_start_consistent(Articulate& articulate, double step, double at);

/// Moves a loaded articulate over the settings' stage of the step, by as many sub-steps as it has: each by Newton's iteration;
/// where that fails, by two halves, five levels deep; where these fail, or it begins with a gap, by the fallback step.
/// Velocities are not yet projected.
void drift_midpoint(Articulate& articulate, const DriftSettings& settings, DriftReport& report);

/// Semi-implicit Euler, 1st order: velocity first, then position, with the row forces found by Newton's iteration
/// with line backtracking on the positions at the end. No projection.
void drift_euler(Articulate& articulate, const DriftSettings& settings, DriftReport& report);
/// The same for a node without rows.
void drift_euler_alone(Node& node, double h);

}  // namespace pantin
