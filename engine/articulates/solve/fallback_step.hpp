#pragma once
#include "articulates/articulate.hpp"

namespace pantin {

/// The step that always answers, for start states with gaps, contradictory anchors and steps that Newton cannot solve:
/// forces, projection of velocities, free drift, then Levenberg and Marquardt on the sum of squared gaps in the mass
/// metric, on positions only, and projection again. It ends at least squares, and only dissipates.
void fallback_step(Articulate& articulate, const DriftSettings& settings, double h, DriftReport& report);
/// Closes gaps of nodes that were displaced where a step starts, in the mass metric; momenta keep their world axes. What pulls
/// by a law keeps the length that it has there, and what gives way is left open; so is all where rows came open by more than a
/// displacement opens in the second order. False where that does not close what it should (a chain that is taut between
/// anchors): they are where they were before, Articulate::saved.
bool close_displaced(Articulate& articulate);

}  // namespace pantin
