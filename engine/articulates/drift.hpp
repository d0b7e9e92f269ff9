#pragma once
#include "articulates/articulate.hpp"

namespace pantin {

/// Moves a loaded articulate by one step: Newton's iteration; where it fails, two half steps, five levels deep; where
/// these fail or the step begins with a gap, the safe step. Velocities are not yet projected.
void drift(Articulate& articulate, const DriftSettings& settings, DriftReport& report);

/// Semi-implicit Euler, 1st order: velocity first, then position, with the row forces found by Newton's iteration
/// with line backtracking on the places at the end. No projection.
void drift_euler(Articulate& articulate, const DriftSettings& settings, DriftReport& report);
/// The same for a node without rows.
void drift_euler_alone(Node& node, double h);

}  // namespace pantin
