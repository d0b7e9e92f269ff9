#pragma once
// The energy-momentum midpoint step of nodes, and its derivative. With R1 = cay(a) R0, a = R0 h (ω0 + ω1)/2 with the spins ω, and forces
// at the mean of the arms at both ends, energy changes only by the work of outer forces, and momentum and angular
// momentum are exact (rotation: Simo and Wong 1991; constraint forces: after Simo, Tarnow and Doblaré 1995).
//
// Of a batch all is in world axes, r̄ = (r0 + r1)/2 is the mean arm:
//   L1 = R0 P0 + h (torque + Σ r̄ x ±f + Σ ±lever f),   Π = R0 (2/h) I R0' a - R0 P0,
//   E = (1 + a^/2) Π - (1 - a^/2) L1.
#include <span>

#include "articulates/articulate.hpp"

namespace pantin {

/// Forces and torques of rows on the nodes.
struct RowLoad {
  Vec3x4 force, torque;
};
inline void add_load(RowLoad& load, const RowEnds& end, const Vec3x4& f, const Vec3x4& arm) {
  const Vec3x4 on_node = f * end.sign;
  load.force += on_node;
  load.torque += cross(arm, on_node) + f * end.lever;
}

/// Sets c, and the arms at the end: r1 = cay(a) r0 = r0 + c (a x r0 + a x (a x r0)/2).
inline void turn_arms(NodeBatch& n, std::span<RowEnds> ends) {
  const Vec3x4& a = n.cayley;
  n.c = 1.0 / (1.0 + 0.25 * norm2(a));
  for (RowEnds& end : ends) {
    const Vec3x4 t = cross(a, end.r0);
    end.r1 = end.r0 + (t + cross(a, t) * 0.5) * n.c;
  }
}

/// Sets the end of the step, the residual E and the correction own_d_cayley; returns the squares of its size [m²].
inline Lanes evaluate(NodeBatch& n, const RowLoad& load, double h) {
  n.row_force = load.force;
  n.x1 = n.x_free + load.force * n.sway;
  n.L1 = n.L_free + load.torque * h;
  const Vec3x4 Pi = n.inertia_rate * n.cayley - n.L0;
  n.Pi_plus_L1 = Pi + n.L1;
  n.E = Pi - n.L1 + cross(n.cayley, n.Pi_plus_L1) * 0.5;
  n.own_d_cayley = n.J_inverse * n.E * -1.0;
  return norm2(n.own_d_cayley) * n.reach2;
}

/// J = dE/da, inverted, with B = Σ r̄ ±f':
///   J = (1 + a^/2) R0 (2/h) I R0' - (Π + L1)^/2 - (1 - a^/2) h dτ/da,
///   dτ/da = c/2 (B - tr(B) 1 - a τ_B'/2 - (B a)^/2 + a^ B' a^/4),  τ_B = axial(B).
inline void invert_jacobian(NodeBatch& n, const Mat3x4& B, double h) {
  const Vec3x4 &a = n.cayley, tau = axial(B);
  const Mat3x4 a_hat = hat(a), Ba_hat = hat(B * a), sum_hat = hat(n.Pi_plus_L1);
  const Lanes s = n.c * (0.5 * h), tr = trace(B) * s;
  const Lanes of_tau[3] = {tau.x, tau.y, tau.z};
  Mat3x4 J;
  for (int k = 0; k < 3; k++) {
    const Vec3x4 quadratic = cross(a, transposed_times(B, a_hat[k]));
    Vec3x4 dtau = (B[k] - a * (of_tau[k] * 0.5) - Ba_hat[k] * 0.5 + quadratic * 0.25) * s;
    (k == 0 ? dtau.x : k == 1 ? dtau.y : dtau.z) -= tr;
    const Vec3x4& d = n.inertia_rate[k];
    J[k] = d - dtau - sum_hat[k] * 0.5 + cross(a, d + dtau) * 0.5;
  }
  n.J_inverse = inverse(J);
  n.own_d_cayley = n.J_inverse * n.E * -1.0;
}

/// The same in a plane, where all rotations are about its normal k: of J and its inverse only J_kk counts,
///   J_kk = (2/h) I_kk - h c/2 (B_kk - tr(B) - a_k τ_Bk/2).
inline void invert_flat_jacobian(NodeBatch& n, const Mat3x4& B, double h, int k) {
  const auto normal = [k](const Vec3x4& v) { return k == 0 ? v.x : k == 1 ? v.y : v.z; };
  const Lanes dtau = (normal(B[k]) - trace(B) - normal(n.cayley) * normal(axial(B)) * 0.5) * (n.c * (0.5 * h));
  const Lanes inverse = 1.0 / (normal(n.inertia_rate[k]) - dtau);
  n.J_inverse = {{zero3x4(), zero3x4(), zero3x4()}};
  Vec3x4& column = n.J_inverse[k];
  (k == 0 ? column.x : k == 1 ? column.y : column.z) = inverse;
  n.own_d_cayley = n.J_inverse * n.E * -1.0;
}

/// W = (2/h) c (1 + a^/2) J⁻¹ (1 - a^/2): the rotation at the end that a unit moment makes, times 2/h².
inline Mat3x4 angular_mobility(const NodeBatch& n, double h) {
  Mat3x4 W = times_hat(n.J_inverse, n.cayley);
  for (int k = 0; k < 3; k++) {
    const Vec3x4 x = n.J_inverse[k] - W[k] * 0.5;
    W[k] = (x + cross(n.cayley, x) * 0.5) * (n.c * (2.0 / h));
  }
  return W;
}

/// Rotation at the end for a change da of the Cayley vector.
inline Vec3x4 rotation(const NodeBatch& n, const Vec3x4& da) { return (da + cross(n.cayley, da) * 0.5) * n.c; }

/// The end of the step is where its start is; its momenta are not touched.
inline void set_end_from_start(Node& n) {
  n.x1 = n.x0;
  n.q1 = n.q0;
  n.R1 = n.R0;
}
/// The start is where the end is, with the momenta that it has, angular ones in principal axes.
inline void set_start_from_end(Node& n) {
  n.x0 = n.x1;
  if (!n.turns) return;
  n.q0 = n.q1;
  n.R0 = n.R1;
  n.spin0 = n.inverse_inertia * n.P0;
}
/// The same with the momenta of the end.
inline void commit(Node& n) {
  n.p0 = n.p1;
  if (n.turns) n.P0 = n.P1;
  set_start_from_end(n);
}

}  // namespace pantin
