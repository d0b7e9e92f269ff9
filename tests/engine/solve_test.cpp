#include "contacts/solve/solve.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "support/random_island.hpp"

using namespace pantin;

TEST_CASE("Impulses of two hundred random islands obey Coulomb's law") {
  const double ratio = GENERATE(1.0, 100.0, 1e4);
  support::Chance chance{std::mt19937_64(7)};
  for (int i = 0; i < 200; i++) {
    ContactIsland island = support::random_island(chance, ratio);
    const support::DenseProblem problem(island);
    solve_island(island, SearchEffort::all, ContactSearch::exact);
    Eigen::VectorXd impulses(problem.q.size());
    for (Eigen::Index k = 0; k < impulses.size(); k++)
      impulses(k) = island.contacts[static_cast<std::size_t>(k / 3)].impulse[static_cast<int>(k % 3)];
    const double small = 1e-5 * problem.q.norm();
    const Eigen::VectorXd u = problem.velocities(impulses);
    for (std::size_t k = 0; k < island.contacts.size(); k++) {
      const auto row = static_cast<Eigen::Index>(3 * k);
      const IslandContact& c = island.contacts[k];
      const double w = problem.W(row, row), normal = impulses(row), bound = c.friction * normal;
      const Eigen::Vector2d along = impulses.segment<2>(row + 1), slip = u.segment<2>(row + 1);
      INFO("island " << i << " contact " << k);
      CHECK(normal >= 0.0);
      CHECK(along.norm() <= bound * (1 + 1e-12));
      CHECK(std::fabs(std::fmin(w * normal, u(row))) < small);
      if (w * (bound - along.norm()) > small) CHECK(slip.norm() < small);
      if (slip.norm() > 10 * small) CHECK((along * slip.norm() + slip * bound).norm() * w < 0.1 * slip.norm());
    }
  }
}
