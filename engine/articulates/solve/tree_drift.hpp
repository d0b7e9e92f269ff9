#pragma once
// Articulates that are trees of ball hinges, moved by their trees: explicitly, to the error that is asked for, where they are
// not too stiff for it.
#include "articulates/articulate.hpp"

namespace pantin {

/// Moves a loaded articulate by its tree over the stage, with an `accuracy` [1/s]: the largest local error of a point per
/// second, relative to the articulate's length. Nothing but its rows and gravity may act on it. `by_tree` tells that it is where its
/// tree has left it. False, and nothing is moved, where it is no tree of hinges, or too stiff; velocities may have been made
/// consistent.
bool drift_as_tree(Articulate& articulate, const DriftSettings& settings, double accuracy, TreeWorkspace& workspace,
                   DriftReport& report);

/// Sets `as_tree`: null where it is no tree of hinges.
void find_tree(Articulate& articulate);

}  // namespace pantin
