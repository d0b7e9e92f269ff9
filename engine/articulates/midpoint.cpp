#include "articulates/midpoint.hpp"

#include "base/functions.hpp"

namespace pantin {

bool solve_alone(Node& n, double h) {
  clear_sums(n);
  n.a = n.O0 * h;
  evaluate(n, h);
  if (!n.turns) return true;
  double last = infinity;
  for (int i = 0; i < 20; i++) {
    invert_jacobian(n, h);
    const Vec3 da = n.J_inverse * n.E;
    const double size = norm(da);
    if (!(size <= 1.0)) return false;
    if (size >= last) return last < 1e-12;  // round-off
    n.a -= da;
    evaluate(n, h);
    if (size < 1e-16) return true;
    last = size;
  }
  return false;
}

void turn_freely(Node& n, double h) {
  const auto turn = [&](int axis, double time) {
    const double angle = n.P0[axis] * n.inverse_inertia[axis] * time;
    const double c = functions::cos(angle), s = functions::sin(angle);
    const int j = (axis + 1) % 3, k = (axis + 2) % 3;
    const double y = n.P0[j], z = n.P0[k];
    n.P0[j] = c * y + s * z;
    n.P0[k] = c * z - s * y;
    Vec3 u = zero3();
    u[axis] = functions::sin(0.5 * angle);
    n.q0 = n.q0 * Quat{functions::cos(0.5 * angle), u[0], u[1], u[2]};
  };
  turn(2, 0.5 * h);
  turn(1, 0.5 * h);
  turn(0, h);
  turn(1, 0.5 * h);
  turn(2, 0.5 * h);
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
