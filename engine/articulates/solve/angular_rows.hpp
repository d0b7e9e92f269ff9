#pragma once
// Rows that tie rotations: positions, forces and work.
#include "articulates/articulate.hpp"

namespace pantin {

/// Sets the axes of an angular row at the start of the step, from the nodes' starts.
void place_angular_row_at_start(Articulate& articulate, Row& row);
/// Axes at the end, with d1 or the angle.
void place_angular_row_at_end(Articulate& articulate, Row& row);

/// Work of an angular row in the step just solved on both nodes [J].
double work_of_angular_row(const Articulate& articulate, const Row& row);

/// Adds a row's force at an arm, in the world [m], to `row_force` and `row_torque` [N m] of a node about its centre.
inline void add_row_force(Node& n, const Row& row, Vec3 arm, Vec3 f) {
  if (row.lever > 0.0) {
    n.row_torque += f * row.lever;
    return;
  }
  n.row_force += f;
  n.row_torque += cross(arm, f);
}

}  // namespace pantin
