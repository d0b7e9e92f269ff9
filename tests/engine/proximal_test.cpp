#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>

#include "contacts/solve/search.hpp"
#include "support/random_island.hpp"

using namespace pantin;

TEST_CASE("Proximal rounds from nothing leave random islands within two percent of their motion") {
  const double ratio = GENERATE(1.0, 100.0);
  support::Chance chance{std::mt19937_64(11)};
  int found = 0;
  for (int i = 0; i < 200; i++) {
    ContactIsland island = support::random_island(chance, ratio);
    prepare(island);
    lay_out_all(island, std::numeric_limits<std::size_t>::max());
    const SearchReport report = proximal_search(island, 30);
    double fastest = 0.0;
    for (const IslandBody& b : island.bodies) fastest = std::max(fastest, norm(b.v));
    found += report.residual <= std::max(island.tolerance, 0.02 * fastest) ? 1 : 0;
    CHECK(report.residual == residual(island));
    for (const IslandContact& c : island.contacts) {
      CHECK(c.impulse[0] >= 0.0);
      CHECK(std::hypot(c.impulse[1], c.impulse[2]) <= c.friction * c.impulse[0] * (1 + 1e-12) + 1e-15);
    }
  }
  CHECK(found >= 195);
}
