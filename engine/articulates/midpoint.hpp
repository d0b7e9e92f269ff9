#pragma once
// The energy-momentum midpoint step of one node, and its derivative. With R1 = R0 cay(a), a = h (O0 + O1)/2, and forces
// at the mean of the arms at both ends, energy changes only by the work of outer forces, and momentum and angular
// momentum are exact (rotation: Simo and Wong 1991; constraint forces: after Simo, Tarnow and Doblaré 1992).
#include "articulates/articulate.hpp"

namespace pantin {

inline void clear_sums(Node& n) {
  n.row_force = n.row_torque = zero3();
  n.row_moment = zero33();
}

/// N = (1 - a^/2)⁻¹ = c (1 + a^/2 + a a'/4), c = 1/(1 + a·a/4).
inline Mat3 half_turn(const Node& n) {
  Mat3 N = hat(n.a * (0.5 * n.c));
  for (int k = 0; k < 3; k++) {
    N[k] += n.a * (0.25 * n.c * n.a[k]);
    N[k][k] += n.c;
  }
  return N;
}

/// The end of the step from `a`, `row_force` and `row_moment`: x1 p1 q1 R1 P1, and the residual E of the rotation:
///   B = N Σ ±l f' R0,  Q = P0 + h (axial B + R0' (torque + Σ ±lever f)),
///   Π1 = I (2a/h - O0),  E = Π1 - Q + a x (Π1 + Q)/2,  P1 = 2 (1 + a^/2)⁻¹ Q - Q.
inline void evaluate(Node& n, double h) {
  n.p1 = n.p0 + (n.row_force + n.force) * h;
  n.x1 = n.x0 + (n.p0 + n.p1) * (0.5 * h * n.inverse_mass);
  if (!n.turns) return;
  const Vec3 a = n.a;
  n.c = 1.0 / (1.0 + 0.25 * dot(a, a));
  const Mat3 N = half_turn(n);
  n.B = N * (n.row_moment * n.R0);
  const Vec3 Q = n.P0 + (axial(n.B) + transposed_times(n.R0, n.torque + n.row_torque)) * h;
  const Vec3 Pi = n.inertia * (a * (2.0 / h) - n.O0);
  n.sum = Pi + Q;
  n.E = Pi - Q + cross(a, n.sum) * 0.5;
  n.P1 = transposed_times(N, Q) * 2.0 - Q;
  const double w = std::sqrt(n.c);
  const Vec3 u = a * (0.5 * w);
  n.q1 = n.q0 * Quat{w, u[0], u[1], u[2]};
  n.R1 = matrix(n.q1);
}

/// J = dE/da, inverted:
///   J = (1 + a^/2)(2/h) I - (Π1 + Q)^/2 - (1 - a^/2) h dτ/da,
///   dτ/da = c/2 (B - tr(B) 1 - a τ'/2 - (B a)^/2 + a^ B' a^/4).
inline void invert_jacobian(Node& n, double h) {
  const Vec3 a = n.a, tau = axial(n.B);
  const Mat3 a_hat = hat(a), Ba_hat = hat(n.B * a), sum_hat = hat(n.sum);
  const Mat3 quartic = a_hat * (transpose(n.B) * a_hat);
  const double s = 0.5 * n.c * h, tr = trace(n.B);
  Mat3 J;
  for (int k = 0; k < 3; k++) {
    Vec3 dtau = (n.B[k] - a * (0.5 * tau[k]) - Ba_hat[k] * 0.5 + quartic[k] * 0.25) * s;
    dtau[k] -= s * tr;
    Vec3 d = zero3();
    d[k] = 2.0 / h * n.inertia[k];
    J[k] = d - dtau - sum_hat[k] * 0.5 + cross(a, d + dtau) * 0.5;
  }
  n.J_inverse = inverse(J);
}

/// W = (2/h) c R0 (1 + a^/2) J⁻¹ (1 - a^/2) R0': the rotation at the end that a moment of unit force makes, times 2/h².
inline Mat3 weight(const Node& n, double h) {
  const Mat3 half = hat(n.a * 0.5);
  const Mat3 left = n.R0 + n.R0 * half, right = identity33() - half;
  return times_transposed((left * (n.c * 2.0 / h)) * (n.J_inverse * right), n.R0);
}

/// Rotation at the end, world axes, for a change da of the Cayley vector.
inline Vec3 rotation(const Node& n, Vec3 da) { return n.R0 * (da + cross(n.a, da) * 0.5) * n.c; }

/// Puts the end of the step in the place of its start.
inline void commit(Node& n) {
  n.x0 = n.x1;
  n.p0 = n.p1;
  if (!n.turns) return;
  n.P0 = n.P1;
  n.q0 = n.q1;
  n.R0 = n.R1;
  n.O0 = n.inverse_inertia * n.P0;
}

/// Solves the rotation of a node without rows to round-off; false where Newton's iteration does not converge.
bool solve_alone(Node& node, double h);
/// Moves a node without rows by h, halving where the rotation is too fast for one step; beyond 2^-5 h it turns about its
/// principal axes one after the other, which always answers.
void drift_alone(Node& node, double h);
/// Turns a free body by h with P fixed in the world: rotations about the principal axes z y x y z (second order).
void turn_freely(Node& node, double h);

}  // namespace pantin
