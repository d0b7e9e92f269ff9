#include "articulates/solve/loose.hpp"

#include "base/functions.hpp"
#include "base/rotation.hpp"

namespace pantin {

namespace {

constexpr double most_turn = 1.0;  // [rad] in one step
constexpr int most_halvings_alone = 8;

struct Inertia {
  Vec3 moments = zero3(), inverse = zero3();
};

/// The inertia that makes the algorithm one of the fourth order. With ω the spin, and k, l the
/// other axes (Hairer and Vilmart 2006, in terms that do not cancel where the least moment is tiny):
///   (I / J)_j = 1 - h² ω_j²/6 + h²/12 Σ_k ω_k² ((I_j - I_k)²/(I_j I_l) - 1 - I_k/I_j)
Inertia preprocessed(const Node& n, Vec3 spin, double h) {
  const Vec3 I = n.inertia;
  const Vec3 angle2 = spin * spin * (h * h / 12.0);
  Inertia J;
  for (int j = 0; j < 3; j++) {
    double sum = 1.0 - 2.0 * angle2[j];
    for (int step = 1; step < 3; step++) {
      const int k = (j + step) % 3, l = (j + 3 - step) % 3;
      const double d = I[j] - I[k];
      const double weight = I[l] <= I[j] ? d * d / (I[j] * I[l]) - 1.0 - I[k] / I[j]
                                         : (d - I[k] - I[l]) / I[l] + I[k] * (I[k] - I[l]) / (I[l] * I[j]);
      sum += angle2[k] * weight;
    }
    J.moments[j] = I[j] / sum;
    J.inverse[j] = sum / I[j];
  }
  return J;
}

/// A turn by Rodrigues' vector b, the axis times the tangent of half the angle, of
///   J b + b x J b = (1 + |b|²) h P/2
/// with P the angular momentum in principal axes and J the preprocessed inertia.
struct Turn {
  Vec3 b = zero3();
  bool found = false;
};

/// The turn of one step, by Newton's method; each equation is divided by its moment.
Turn find_turn(const Node& n, Vec3 P, double h) {
  const Vec3 spin = P * n.inverse_inertia;
  Turn turn;
  if (!(norm2(spin) * h * h <= most_turn * most_turn)) return turn;
  const auto [J, inverse_J] = preprocessed(n, spin, h);
  const Vec3 right = P * inverse_J * (0.5 * h), skew = vec(J[2] - J[1], J[0] - J[2], J[1] - J[0]) * inverse_J;
  Vec3& b = turn.b;
  b = right;
  double last = infinity;
  for (int i = 0; i < 20; i++) {
    const Vec3 residual = b + skew * vec(b[1] * b[2], b[2] * b[0], b[0] * b[1]) - right * (1.0 + norm2(b));
    Mat3 jacobian = outer(right, b) * -2.0;
    for (int k = 0; k < 3; k++) {
      const int l = (k + 1) % 3, m = (k + 2) % 3;
      jacobian[k][k] += 1.0;
      jacobian[k][l] += skew[l] * b[m];  // column k
      jacobian[k][m] += skew[m] * b[l];
    }
    const Vec3 db = inverse(jacobian) * residual;
    const double size = norm(db);
    if (!(size <= 1.0)) return turn;
    if (size >= last) {  // round-off
      turn.found = last < 1e-12;
      return turn;
    }
    b -= db;
    turn.found = size < 1e-16;
    if (turn.found) return turn;
    last = size;
  }
  return turn;
}

void renormalise(Node& n) {
  n.q0 = normalised(n.q0);
  n.R0 = matrix(n.q0);
  n.spin0 = n.inverse_inertia * n.P0;
}

/// Turns by b, with the angular momentum fixed in the world.
void turn_by(Node& n, Vec3 b) {
  const double c = 1.0 / (1.0 + norm2(b)), w = std::sqrt(c);
  const Vec3 t = cross(b, n.P0);
  n.P0 += (cross(b, t) - t) * (2.0 * c);
  n.q0 = n.q0 * Quat{w, b[0] * w, b[1] * w, b[2] * w};
}

/// Index of the principal axis whose inertia differs most from the other two, which are most alike.
int most_distinct(Vec3 I) {
  const double d01 = std::fabs(I[0] - I[1]), d12 = std::fabs(I[1] - I[2]), d20 = std::fabs(I[2] - I[0]);
  return d01 <= d12 && d01 <= d20 ? 2 : d12 <= d20 ? 0 : 1;
}

bool is_symmetric(Vec3 I) { return I[0] == I[1] || I[1] == I[2] || I[2] == I[0]; }

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

/// Exactly as a symmetric top, and, before and after, by half of what the difference of its two most alike moments makes
/// (Touma and Wisdom 1994); it always answers.
void turn_as_symmetric(Node& n, double h) {
  const int axis = most_distinct(n.inertia), j = (axis + 1) % 3, k = (axis + 2) % 3;
  const Vec3 inverse = n.inverse_inertia;
  const auto correct = [&] {
    if (inverse[k] != inverse[j]) turn_about(n, k, n.P0[k] * (inverse[k] - inverse[j]) * (0.5 * h));
  };
  correct();
  const double size = norm(n.P0), angle = size * inverse[j] * h;  // of a symmetric top, about its angular momentum
  n.q0 = n.q0 * quaternion_of(direction(n.P0), angle);
  if (inverse[axis] != inverse[j])
    turn_about(n, axis, n.P0[axis] * (inverse[axis] - inverse[j]) * h);  // and about itself
  correct();
}

void turn(Node& n, Vec3 torque, double h, int depth) {
  const bool symmetric = is_symmetric(n.inertia);
  const Vec3 kicked = n.P0 + transposed_times(n.R0, torque) * (0.5 * h);
  const Turn one = symmetric ? Turn{} : find_turn(n, kicked, h);
  if (!symmetric && !one.found && depth < most_halvings_alone) {
    turn(n, torque, 0.5 * h, depth + 1);
    turn(n, torque, 0.5 * h, depth + 1);
    return;
  }
  n.P0 = kicked;
  one.found ? turn_by(n, one.b) : turn_as_symmetric(n, h);
  renormalise(n);
  n.P0 += transposed_times(n.R0, torque) * (0.5 * h);
  n.spin0 = n.inverse_inertia * n.P0;
}

}  // namespace

void turn_freely(Node& n, double h) { turn(n, zero3(), h, 0); }

void drift_alone(Node& n, double h) {
  const Vec3 p = n.p0 + n.force * h;
  n.x0 += (n.p0 + p) * (0.5 * h * n.inverse_mass);
  n.p0 = p;
  if (n.turns) turn(n, n.torque, h, 0);
}

}  // namespace pantin
