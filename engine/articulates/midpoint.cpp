#include "articulates/midpoint.hpp"

#include "base/functions.hpp"

namespace pantin {

namespace {

/// The rotation of a node without rows, principal axes: the same equations with no force of rows.
struct FreeRotation {
  Vec3 Q, E, sum;
};

/// Sets the end of the step for a; returns what Newton's iteration needs.
FreeRotation rotate_by(Node& n, double h) {
  const Vec3 a = n.a;
  const double c = 1.0 / (1.0 + 0.25 * dot(a, a)), w = std::sqrt(c);
  const Vec3 Q = n.P0 + transposed_times(n.R0, n.torque) * h, Pi = n.inertia * (a * (2.0 / h) - n.O0), sum = Pi + Q;
  n.P1 = (Q - cross(a, Q) * 0.5 + a * (0.25 * dot(a, Q))) * (2.0 * c) - Q;  // 2 (1 + a^/2)⁻¹ Q - Q
  const Vec3 u = a * (0.5 * w);
  n.q1 = n.q0 * Quat{w, u[0], u[1], u[2]};
  n.R1 = matrix(n.q1);
  return {Q, Pi - Q + cross(a, sum) * 0.5, sum};
}

/// J = (1 + a^/2)(2/h) I - (Π1 + Q)^/2, with 1 for I about axes that it cannot turn about
Mat3 jacobian(const Node& n, const FreeRotation& r, double h) {
  const Mat3 d = diagonal(n.inertia * (2.0 / h)), sum_hat = hat(r.sum);
  Mat3 J;
  for (int k = 0; k < 3; k++) {
    J[k] = d[k] + cross(n.a, d[k]) * 0.5 - sum_hat[k] * 0.5;
    if (n.inertia[k] == 0.0) J[k][k] = 1.0;
  }
  return J;
}

/// Solves the step to round-off; false where Newton's iteration does not converge.
bool solve_alone(Node& n, double h) {
  n.p1 = n.p0 + n.force * h;
  n.x1 = n.x0 + (n.p0 + n.p1) * (0.5 * h * n.inverse_mass);
  if (!n.turns) return true;
  n.a = n.O0 * h;
  FreeRotation r = rotate_by(n, h);
  double last = infinity;
  for (int i = 0; i < 20; i++) {
    const Vec3 da = inverse(jacobian(n, r, h)) * r.E;
    const double size = norm(da);
    if (!(size <= 1.0)) return false;
    if (size >= last) return last < 1e-12;  // round-off
    n.a -= da;
    r = rotate_by(n, h);
    if (size < 1e-16) return true;
    last = size;
  }
  return false;
}

/// Index of the principal axis whose inertia differs most from the other two, which are most alike.
int most_distinct(Vec3 I) {
  const double d01 = std::fabs(I[0] - I[1]), d12 = std::fabs(I[1] - I[2]), d20 = std::fabs(I[2] - I[0]);
  return d01 <= d12 && d01 <= d20 ? 2 : d12 <= d20 ? 0 : 1;
}

/// Turns the body about its own axis by an angle, with the angular momentum fixed in the world.
void turn_about(Node& n, int axis, double angle) {
  const double c = functions::cos(angle), s = functions::sin(angle);
  const int j = (axis + 1) % 3, k = (axis + 2) % 3;
  const double y = n.P0[j], z = n.P0[k];
  n.P0[j] = c * y + s * z;
  n.P0[k] = c * z - s * y;
  Vec3 u = zero3();
  u[axis] = functions::sin(0.5 * angle);
  n.q0 = n.q0 * Quat{functions::cos(0.5 * angle), u[0], u[1], u[2]};
}

}  // namespace

void turn_freely(Node& n, double h) {
  const int axis = most_distinct(n.inertia), j = (axis + 1) % 3, k = (axis + 2) % 3;
  const Vec3 O = n.inverse_inertia;
  const auto correct = [&] { turn_about(n, k, n.P0[k] * (O[k] - O[j]) * (0.5 * h)); };
  correct();
  const double size = norm(n.P0), angle = size * O[j] * h;  // of a symmetric top, about its angular momentum
  const Vec3 u = direction(n.P0) * functions::sin(0.5 * angle);
  n.q0 = n.q0 * Quat{functions::cos(0.5 * angle), u[0], u[1], u[2]};
  turn_about(n, axis, n.P0[axis] * (O[axis] - O[j]) * h);  // and about itself
  correct();
  n.q0 = normalised(n.q0);
  n.R0 = matrix(n.q0);
  n.O0 = n.inverse_inertia * n.P0;
}

namespace {

void drift_halved(Node& n, double h, int depth) {
  if (solve_alone(n, h)) return commit(n);
  if (depth < 5) {
    drift_halved(n, 0.5 * h, depth + 1);
    drift_halved(n, 0.5 * h, depth + 1);
    return;
  }
  n.P0 += transposed_times(n.R0, n.torque) * (0.5 * h);
  turn_freely(n, h);
  n.P0 += transposed_times(n.R0, n.torque) * (0.5 * h);
  n.O0 = n.inverse_inertia * n.P0;
  n.x0 = n.x1;
  n.p0 = n.p1;
}

}  // namespace

void drift_alone(Node& n, double h) { drift_halved(n, h, 0); }

}  // namespace pantin
