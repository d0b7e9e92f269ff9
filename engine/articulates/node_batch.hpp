#pragma once
// What the solver works on: the nodes of an articulate four at a time, one to a lane, with their ends of rows. With
// `cayley`, a, in world axes, R1 = cay(a) R0, and R0 drops out of the equations.
#include <cstdint>

#include "base/vectors4.hpp"

namespace pantin {

/// One end of a row at each of four nodes.
struct alignas(64) RowEnds {
  Vec3x4 l;       // [m] arm in principal axes; 0 of an angular row
  Vec3x4 r0, r1;  // [m] arm in the world
  // force on the node per force of the row: 1, -1; 0 of an angular row, and where the node has no more rows
  Lanes sign;
  Lanes lever;                                // [m] torque on the node per force of an angular row, else 0
  std::array<std::uint32_t, batch_size> row;  // any where the node has no more
  std::array<std::uint32_t, batch_size> to;   // place in Articulate::at_ends: the last where the node has no more rows
};

/// Four nodes. Those that do not turn count as turning ones without arms.
struct alignas(64) NodeBatch {
  // of the step being solved
  Vec3x4 cayley;                  // unknown: the Cayley vector a
  Vec3x4 cayley_saved, d_cayley;  // where a line search starts, and its direction
  Vec3x4 own_d_cayley;            // correction by the node's own residual
  Lanes c;                        // 1/(1 + a·a/4)
  Vec3x4 x1, row_force;
  Vec3x4 L1;             // R1 P1
  Vec3x4 E, Pi_plus_L1;  // residual of the rotation; Π + L1
  Mat3x4 J_inverse;
  // constants of the step
  Vec3x4 x_free, L_free;  // x1 and L1 without forces of rows
  Vec3x4 L0;              // R0 P0
  Mat3x4 inertia_rate;    // R0 (2/h) I R0'
  Lanes sway;             // h²/2m
  // of a projection of velocities
  Vec3x4 p, L;                   // momenta, angular ones in world axes
  Mat3x4 inverse_inertia_world;  // R I⁻¹ R'
  // constants
  Vec3x4 inertia, inverse_inertia;
  Lanes inverse_mass;
  Lanes reach2;
  std::uint32_t first_row;            // smallest row of its nodes
  std::uint32_t first_end, last_end;  // in Articulate::ends
  std::uint32_t count;                // of nodes
};

}  // namespace pantin
