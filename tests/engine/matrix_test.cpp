#include "contacts/solve/matrix.hpp"

#include <catch2/catch.hpp>
#include <initializer_list>

#include "support/random_island.hpp"

using namespace pantin;

TEST_CASE("matrix: whether it is too dense does not depend on what was laid out in its memory before") {
  support::Chance chance{std::mt19937_64(7)};
  int dense = 0;
  for (int i = 0; i < 50; i++) {
    ContactIsland used = support::random_island(chance, 1.0);
    for (const std::size_t most : std::initializer_list<std::size_t>{100'000, 100, 10'000, 30, 300, 10, 3000}) {
      ContactIsland fresh = used;
      fresh.all = {};
      const bool laid_out = lay_out_all(fresh, most);
      INFO("island " << i << ", at most " << most << " updates");
      CHECK(lay_out_all(used, most) == laid_out);
      if (!laid_out) dense++;
    }
  }
  CHECK(dense > 50);
}
