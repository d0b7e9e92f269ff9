#include "support/random_island.hpp"

#include <Eigen/Cholesky>
#include <cmath>

namespace pantin::support {

namespace {

IslandBody random_body(Chance& chance, double ratio) {
  IslandBody b;
  b.mass = std::pow(ratio, chance.between(0.0, 1.0));
  b.inverse_mass = 1.0 / b.mass;
  const Vec3 axis = chance.direction(), other = direction(cross(axis, chance.direction()));
  const Mat3 R = {{axis, other, cross(axis, other)}};
  b.inertia = b.inverse_inertia = b.root = zero33();
  for (int i = 0; i < 3; i++) {
    const double moment = b.mass * chance.between(0.05, 0.2);
    b.inertia += outer(R[i], R[i]) * moment;
    b.inverse_inertia += outer(R[i], R[i]) * (1.0 / moment);
    b.root[i] = R[i] * std::sqrt(1.0 / moment);
  }
  b.reach = 0.5;
  b.v0 = chance.vector(0.6);
  b.w0 = chance.vector(1.0);
  return b;
}

}  // namespace

ContactIsland random_island(Chance& chance, double ratio) {
  ContactIsland island;
  const int bodies = 1 + chance.below(10);
  for (int i = 0; i < bodies; i++) island.bodies.push_back(random_body(chance, ratio));
  const int contacts = bodies + chance.below(2 * bodies + 1);
  for (int k = 0; k < contacts; k++) {
    IslandContact c;
    c.a = k < bodies ? k : chance.below(bodies);
    c.b = c.a == 0 || chance.below(3) == 0 ? -1 : chance.below(c.a);
    c.ra = chance.direction() * 0.5;
    c.rb = chance.direction() * 0.5;
    const Vec3 n = chance.direction(), t = direction(cross(n, chance.direction()));
    c.frame = {{n, t, cross(n, t)}};
    c.friction = chance.below(8) == 0 ? 0.0 : chance.between(0.0, 1.2);
    c.bias = vec(chance.below(2) == 0 ? 0.0 : chance.between(0.0, 0.5), 0, 0);
    c.height = chance.between(0.0, 1.0);
    island.contacts.push_back(c);
  }
  island.tolerance = 1e-8;
  return island;
}

DenseProblem::DenseProblem(const ContactIsland& island) {
  const auto bodies = static_cast<Eigen::Index>(island.bodies.size()),
             contacts = static_cast<Eigen::Index>(island.contacts.size());
  Eigen::MatrixXd G = Eigen::MatrixXd::Zero(3 * contacts, 6 * bodies),
                  M = Eigen::MatrixXd::Zero(6 * bodies, 6 * bodies);
  Eigen::VectorXd v(6 * bodies), bias(3 * contacts);
  for (Eigen::Index i = 0; i < bodies; i++) {
    const IslandBody& b = island.bodies[static_cast<std::size_t>(i)];
    for (int r = 0; r < 3; r++) {
      M(6 * i + r, 6 * i + r) = b.mass;
      v(6 * i + r) = b.v0[r];
      v(6 * i + 3 + r) = b.w0[r];
      for (int s = 0; s < 3; s++) M(6 * i + 3 + r, 6 * i + 3 + s) = b.inertia[s][r];
    }
  }
  for (Eigen::Index k = 0; k < contacts; k++) {
    const IslandContact& c = island.contacts[static_cast<std::size_t>(k)];
    for (int row = 0; row < 3; row++) {
      bias(3 * k + row) = c.bias[row];
      const auto add = [&](std::int32_t body, Vec3 arm, double sign) {
        if (body < 0) return;
        const Vec3 turn = cross(arm, c.frame[row]);
        for (int s = 0; s < 3; s++) {
          G(3 * k + row, 6 * body + s) += sign * c.frame[row][s];
          G(3 * k + row, 6 * body + 3 + s) += sign * turn[s];
        }
      };
      add(c.a, c.ra, 1.0);
      add(c.b, c.rb, -1.0);
    }
  }
  W = G * M.ldlt().solve(G.transpose());
  q = G * v + bias;
}

Eigen::VectorXd DenseProblem::velocities(const Eigen::VectorXd& impulses) const { return W * impulses + q; }

}  // namespace pantin::support
