#include "support/hinged.hpp"

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>

namespace pantin::reference {

namespace {

using Matrix = Eigen::Matrix3d;
using Vector = Eigen::Vector3d;

Matrix hat(const Vector& v) {
  Matrix m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

/// A body as it turns.
struct Turned {
  Matrix R, inverse_inertia;
  Vector spin, bend;  ///< [rad/s], [rad/s²] of it alone
};

Turned turned(const HingedBody& body, const State& y, Eigen::Index at) {
  Turned t;
  t.R = Eigen::Quaterniond(y(at + 6), y(at + 7), y(at + 8), y(at + 9)).normalized().toRotationMatrix();
  t.spin = y.segment<3>(at + 10);
  const bool turns = body.inertia.norm() > 0.0;
  t.inverse_inertia = turns ? Matrix(t.R * body.inertia.inverse() * t.R.transpose()) : Matrix::Zero();
  const Vector momentum = t.R * body.inertia * t.R.transpose() * t.spin;
  t.bend = t.inverse_inertia * momentum.cross(t.spin);
  return t;
}

}  // namespace

State start(const Hinged& hinged) {
  State y(13 * static_cast<Eigen::Index>(hinged.bodies.size()));
  Eigen::Index at = 0;
  for (const HingedBody& b : hinged.bodies) {
    y.segment<13>(at) << b.at, b.velocity, 1, 0, 0, 0, b.spin;
    at += 13;
  }
  return y;
}

State rate(const Hinged& hinged, const State& y) {
  const std::size_t n = hinged.hinges.size();
  std::vector<Turned> now;
  for (std::size_t i = 0; i < hinged.bodies.size(); i++)
    now.push_back(turned(hinged.bodies[i], y, 13 * static_cast<Eigen::Index>(i)));
  const auto arm = [&](int body, const BallHinge& hinge) -> Vector {
    const auto i = static_cast<std::size_t>(body);
    return now[i].R * (hinge.at - hinged.bodies[i].at);
  };
  State right = State::Zero(3 * static_cast<Eigen::Index>(n));
  std::vector<std::vector<std::pair<int, double>>> on(hinged.bodies.size());  // hinges of a body, with signs
  for (std::size_t k = 0; k < n; k++)
    for (const auto& [body, sign] : {std::pair{hinged.hinges[k].a, 1.0}, std::pair{hinged.hinges[k].b, -1.0}}) {
      if (body < 0) continue;
      const Turned& t = now[static_cast<std::size_t>(body)];
      const Vector r = arm(body, hinged.hinges[k]);
      right.segment<3>(3 * static_cast<Eigen::Index>(k)) -=
          sign * (hinged.gravity + t.bend.cross(r) + t.spin.cross(t.spin.cross(r)));
      on[static_cast<std::size_t>(body)].emplace_back(static_cast<int>(k), sign);
    }
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t i = 0; i < on.size(); i++)
    for (const auto& [k, sign_k] : on[i])
      for (const auto& [l, sign_l] : on[i]) {
        const Matrix of =
            sign_k * sign_l *
            (Matrix::Identity() / hinged.bodies[i].mass -
             hat(arm(static_cast<int>(i), hinged.hinges[static_cast<std::size_t>(k)])) * now[i].inverse_inertia *
                 hat(arm(static_cast<int>(i), hinged.hinges[static_cast<std::size_t>(l)])));
        for (int row = 0; row < 3; row++)
          for (int column = 0; column < 3; column++) entries.emplace_back(3 * k + row, 3 * l + column, of(row, column));
      }
  Eigen::SparseMatrix<double> matrix(right.size(), right.size());
  matrix.setFromTriplets(entries.begin(), entries.end());
  const State force = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix).solve(right);
  State dy(y.size());
  for (std::size_t i = 0; i < on.size(); i++) {
    const auto at = 13 * static_cast<Eigen::Index>(i);
    Vector a = hinged.gravity, bend = now[i].bend;
    for (const auto& [k, sign] : on[i]) {
      const Vector f = sign * force.segment<3>(3 * k);
      a += f / hinged.bodies[i].mass;
      bend += now[i].inverse_inertia * arm(static_cast<int>(i), hinged.hinges[static_cast<std::size_t>(k)]).cross(f);
    }
    const Vector w = now[i].spin;
    const Eigen::Quaterniond q(y(at + 6), y(at + 7), y(at + 8), y(at + 9));
    const Eigen::Quaterniond turning = Eigen::Quaterniond(0, w.x() / 2, w.y() / 2, w.z() / 2) * q;
    dy.segment<13>(at) << y.segment<3>(at + 3), a, turning.w(), turning.vec(), bend;
  }
  return dy;
}

State advance(const Hinged& hinged, double time, int pieces) {
  return integrate([&](const State& y) { return rate(hinged, y); }, start(hinged), time, pieces);
}

Eigen::Vector3d centre(const State& y, int body) { return y.segment<3>(13 * body); }

double energy(const Hinged& hinged, const State& y) {
  double sum = 0.0;
  for (std::size_t i = 0; i < hinged.bodies.size(); i++) {
    const auto at = 13 * static_cast<Eigen::Index>(i);
    const HingedBody& b = hinged.bodies[i];
    const Turned t = turned(b, y, at);
    const Vector spin = t.R.transpose() * t.spin;
    sum += 0.5 * b.mass * y.segment<3>(at + 3).squaredNorm() + 0.5 * spin.dot(b.inertia * spin) -
           b.mass * hinged.gravity.dot(y.segment<3>(at));
  }
  return sum;
}

}  // namespace pantin::reference
