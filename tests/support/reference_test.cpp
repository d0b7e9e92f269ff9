// The references are judged by themselves: they must not change when their step is halved, must keep what the equations
// keep, and must agree where two of them describe the same thing.
#include "support/reference.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

using namespace pantin;

TEST_CASE("reference: the plane chain has converged") {
  const int links = GENERATE(1, 3, 10);
  CAPTURE(links);
  const reference::PlaneChain chain = reference::plane_chain(links);
  const reference::State once = reference::advance(chain, 1.0, 50), twice = reference::advance(chain, 1.0, 100);
  CHECK((reference::centre(chain, once, links - 1) - reference::centre(chain, twice, links - 1)).norm() <= 1e-9);
  CHECK(std::fabs(reference::energy(chain, once) - reference::energy(chain, chain.start)) <= 1e-9);
}

TEST_CASE("reference: the heavy plane chain has converged") {
  const reference::PlaneChain chain = reference::heavy_plane_chain(10, 1e3);
  const reference::State once = reference::advance(chain, 1.0, 500), twice = reference::advance(chain, 1.0, 1000);
  CHECK((reference::centre(chain, once, 10) - reference::centre(chain, twice, 10)).norm() <= 1e-9);
  CHECK(std::fabs(reference::energy(chain, once) - reference::energy(chain, chain.start)) <= 1e-6);
}

TEST_CASE("reference: the plane ring has converged, and stays closed") {
  const reference::PlaneChain ring = reference::plane_ring(24);
  const reference::State once = reference::advance(ring, 1.0, 50), twice = reference::advance(ring, 1.0, 100);
  CHECK((reference::centre(ring, once, 11) - reference::centre(ring, twice, 11)).norm() <= 1e-9);
  CHECK(std::fabs(reference::energy(ring, once) - reference::energy(ring, ring.start)) <= 1e-9);
  Eigen::Vector2d end = Eigen::Vector2d::Zero();
  for (int j = 0; j < 24; j++) end += Eigen::Vector2d(std::cos(once(j)), std::sin(once(j)));
  CHECK(end.norm() <= 1e-10);
}

TEST_CASE("reference: the double pendulum has converged, and is a chain of two point masses") {
  const double time = GENERATE(1.0, 2.0);
  const reference::State once = reference::double_pendulum(time, 50), twice = reference::double_pendulum(time, 100);
  CHECK((once - twice).norm() <= 1e-9);
  reference::PlaneChain chain;
  chain.links = {{1, 1, 1, 0}, {1, 1, 1, 0}};
  chain.start = reference::State::Zero(4);
  const reference::State angles = reference::advance(chain, time, 50);
  CHECK(angles(0) + std::numbers::pi / 2 == Approx(once(0)).margin(1e-9));
  CHECK(angles(1) + std::numbers::pi / 2 == Approx(once(1)).margin(1e-9));
}

TEST_CASE("reference: the free top has converged and keeps energy and momentum") {
  const Eigen::Vector3d once = reference::top(100.0, 500), twice = reference::top(100.0, 1000);
  CHECK((once - twice).norm() <= 1e-9);
  const Eigen::Vector3d inertia(1, 2, 3), start(0.01, 1, 0.01);
  CHECK(once.cwiseProduct(inertia).norm() == Approx(start.cwiseProduct(inertia).norm()).epsilon(1e-11));
  CHECK(once.cwiseProduct(inertia).dot(once) == Approx(start.cwiseProduct(inertia).dot(start)).epsilon(1e-11));
}
