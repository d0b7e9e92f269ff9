// Neighbour rows hold each pair that is near enough, once, and no other.
#include "laws/run/neighbours.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <limits>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/check.hpp"
#include "laws/run/skin.hpp"
#include "support/sites.hpp"

using namespace pantin;

namespace {

using Pair = std::pair<std::uint32_t, std::uint32_t>;
using Families = std::vector<std::uint32_t>;

std::vector<Pair> pairs_of(const Sites& sites, const NeighbourList& rows) {
  std::vector<Pair> pairs;
  for (const auto& phase : rows.phases())
    for (const Slab& slab : phase)
      for (const NeighbourRow& row : slab.rows)
        for (std::uint32_t k = 0; k < row.count; k++) {
          const std::uint32_t j = slab.list[row.begin + k];
          if (j == sites.dummy()) continue;
          pairs.push_back(rows.within() ? Pair(std::minmax(row.site, j)) : Pair(row.site, j));
        }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

bool has(const Families& families, std::uint32_t family) {
  return std::find(families.begin(), families.end(), family) != families.end();
}

bool have_a_body_in_common(const Sites& sites, std::uint32_t i, std::uint32_t j) {
  const auto bodies = [&](std::uint32_t site) {
    const Kin& kin = sites.kin[site];
    std::set<std::uint32_t> set;
    for (std::uint32_t k = 0; k < kin.count; k++) set.insert(sites.bodies_of_hinges[kin.begin + k]);
    if (kin.count == 0 && kin.first != 0) set.insert(kin.first);
    return set;
  };
  const std::set<std::uint32_t> others = bodies(j);
  for (std::uint32_t body : bodies(i))
    if (others.contains(body)) return true;
  return false;
}

/// Each pair once for every image that is within reach.
std::vector<Pair> all_pairs(const Sites& sites, const Box& box, const Families& a, const Families& b, double reach) {
  std::vector<Pair> pairs;
  const int images = box.periodic() ? 1 : 0;
  for (std::uint32_t i = 0; i < sites.n; i++)
    for (std::uint32_t j = 0; j < sites.n; j++) {
      const bool meet = has(a, sites.family[i]) && has(b, sites.family[j]) && (a != b || i < j);
      if (!meet || have_a_body_in_common(sites, i, j)) continue;
      for (int x = -images; x <= images; x++)
        for (int y = -images; y <= images; y++)
          for (int z = -images; z <= images; z++)
            if (norm(sites.x[j] + box.edge * vec(x, y, z) - sites.x[i]) < reach) pairs.push_back({i, j});
    }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

void check_rows(const Sites& sites, const Box& box, const Families& a, const Families& b, double cutoff, double skin) {
  Workers workers;
  NeighbourList rows;
  rows.build(sites, box, a, b, cutoff, skin, workers);
  const std::vector<Pair> expected = all_pairs(sites, box, a, b, cutoff + skin);
  CHECK(rows.pairs() == expected.size());
  CHECK(pairs_of(sites, rows) == expected);
}

/// Pairs whose numbers differ by `step`.
Exclusions apart(const Sites& sites, std::uint32_t step) {
  Exclusions exclusions;
  for (std::uint32_t i = 0; i < sites.n; i++) {
    exclusions.begin.push_back(static_cast<std::uint32_t>(exclusions.list.size()));
    if (i >= step) exclusions.list.push_back(i - step);
    if (i + step < sites.n) exclusions.list.push_back(i + step);
  }
  exclusions.begin.push_back(static_cast<std::uint32_t>(exclusions.list.size()));
  return exclusions;
}

Box cube(double edge) { return {vec(edge, edge, edge)}; }

}  // namespace

TEST_CASE("rows: one family in open space") {
  const double cutoff = GENERATE(0.3, 1.0, 2.5, 8.0, 40.0);
  check_rows(cases::random_sites(), {}, {0}, {0}, cutoff, 0.1 * cutoff);
}

TEST_CASE("rows: one family in a periodic box") {
  const double cutoff = GENERATE(0.3, 1.0, 1.7, 2.5, 3.9, 5.0);
  check_rows(cases::random_sites(), cube(10.0), {0}, {0}, cutoff, 0.3);
  check_rows(cases::random_sites(), {vec(10, 15, 31)}, {0}, {0}, cutoff, 0.3);
}

TEST_CASE("rows: in a row a neighbour is within reach at the row's shift") {
  const Sites sites = cases::random_sites();
  Workers workers;
  NeighbourList rows;
  rows.build(sites, cube(10.0), Families{0}, Families{0}, 2.0, 0.2, workers);
  for (const auto& phase : rows.phases())
    for (const Slab& slab : phase)
      for (const NeighbourRow& row : slab.rows)
        for (std::uint32_t k = 0; k < row.count; k++) {
          const std::uint32_t j = slab.list[row.begin + k];
          if (j != sites.dummy()) REQUIRE(norm(sites.x[j] + rows.shifts()[row.shift] - sites.x[row.site]) < 2.2);
        }
}

TEST_CASE("rows: two families") {
  const Sites sites = cases::random_sites({.families = 3});
  const double cutoff = GENERATE(0.5, 2.0, 4.5, infinity);
  check_rows(sites, {}, {0}, {1}, cutoff, 0.2);
  check_rows(sites, {}, {2}, {0, 1}, cutoff, 0.2);
  check_rows(sites, {}, {0, 2}, {0, 2}, cutoff, 0.2);
  if (cutoff < infinity) check_rows(sites, cube(10.0), {2}, {0, 1}, cutoff, 0.2);
}

TEST_CASE("rows: without a cutoff all pairs are meant") {
  check_rows(cases::random_sites({.count = 3}), {}, {0}, {0}, infinity, 0.0);
  check_rows(cases::random_sites({.count = 1101}), {}, {0}, {0}, infinity, 0.0);
  check_rows(cases::random_sites({.count = 1101, .families = 2}), {}, {0}, {1}, infinity, 0.0);
}

TEST_CASE("rows: a flat scene and a straight one are sorted along their length") {
  Sites sites = cases::random_sites();
  for (std::size_t i = 0; i < sites.n; i++) sites.x[i][2] = 0.0;
  check_rows(sites, {}, {0}, {0}, 0.8, 0.1);
  for (std::size_t i = 0; i < sites.n; i++) sites.x[i] = vec(1, static_cast<double>(sites.x[i][1]), 1);
  check_rows(sites, {}, {0}, {0}, 0.1, 0.01);
}

TEST_CASE("rows: points of a body, hinges of it and given pairs are left out") {
  Sites sites = cases::random_sites({.count = 300});
  for (std::uint32_t i = 0; i < sites.n; i++) sites.kin[i].first = i % 3 == 0 ? 0 : 1 + i / 7;
  for (std::uint32_t i = 4; i + 9 < sites.n; i += 9) {
    sites.kin[i] = {1 + i / 7, static_cast<std::uint32_t>(sites.bodies_of_hinges.size()), 2 + i % 2};
    for (std::uint32_t k = 0; k < sites.kin[i].count; k++) sites.bodies_of_hinges.push_back(1 + (i + 7 * k) / 7);
  }
  const Exclusions further = apart(sites, 5);
  check_rows(sites, {}, {0}, {0}, 3.0, 0.3);
  check_rows(sites, cube(10.0), {0}, {0}, 3.0, 0.3);
  check_rows(sites, {}, {0}, {0}, infinity, 0.0);
  Workers workers;
  for (const double cutoff : {3.0, infinity}) {
    NeighbourList rows;
    rows.build(sites, {}, Families{0}, Families{0}, cutoff, 0.0, workers, further);
    std::vector<Pair> expected = all_pairs(sites, {}, {0}, {0}, cutoff);
    std::erase_if(expected, [](const Pair& pair) { return pair.second - pair.first == 5; });
    CHECK(pairs_of(sites, rows) == expected);
  }
}

TEST_CASE("rows: two clusters far apart, along every axis") {
  Sites sites = cases::random_sites({.count = 400, .edge = 3.0});
  for (std::size_t i = 0; i < sites.n; i += 2) sites.x[i] += vec(1e6, -1e6, 1e6);
  check_rows(sites, {}, {0}, {0}, 1.0, 0.1);
  Workers workers;
  NeighbourList rows;
  rows.build(sites, {}, Families{0}, Families{0}, 1.0, 0.1, workers);
  CHECK(rows.memory() < 1'000'000);
  for (std::size_t i = 0; i < sites.n; i += 2) sites.x[i] += vec(0, 0, 1e13);
  check_rows(sites, {}, {0}, {0}, 1.0, 0.1);
}

TEST_CASE("rows: the same for any number of threads, and slabs of a phase share no site") {
  const Sites sites = cases::random_sites({.count = 20000, .edge = 30.0, .families = 2});
  const Box box = GENERATE(Box{}, cube(30.0));
  const Families b = GENERATE(Families{0}, Families{1});
  Workers one(1), four(4);
  NeighbourList rows, others;
  rows.build(sites, box, Families{0}, b, 1.5, 0.3, one);
  others.build(sites, box, Families{0}, b, 1.5, 0.3, four);
  REQUIRE(rows.phases().size() == 2);
  REQUIRE(others.phases().size() == 2);
  REQUIRE(rows.pairs() > 1000);
  for (std::size_t p = 0; p < 2; p++) {
    std::vector<std::size_t> owner(sites.n, 0);
    REQUIRE(rows.phases()[p].size() == others.phases()[p].size());
    for (std::size_t s = 0; s < rows.phases()[p].size(); s++) {
      const Slab &slab = rows.phases()[p][s], &other = others.phases()[p][s];
      REQUIRE(std::equal(slab.own.begin(), slab.own.end(), other.own.begin(), other.own.end()));
      REQUIRE(slab.rows.size() == other.rows.size());
      const auto take = [&](std::uint32_t i) {
        if (i == sites.dummy()) return;
        REQUIRE((owner[i] == 0 || owner[i] == s + 1));
        owner[i] = s + 1;
      };
      for (const NeighbourRow& row : slab.rows) {
        take(row.site);
        for (std::uint32_t k = 0; k < row.count; k++) take(slab.list[row.begin + k]);
      }
    }
  }
}

TEST_CASE("rows: what cannot be meant is refused") {
  Workers workers;
  NeighbourList rows;
  Sites sites = cases::random_sites();
  const auto build = [&](const Box& box, double cutoff) {
    rows.build(sites, box, Families{0}, Families{0}, cutoff, 0.0, workers);
  };
  CHECK_THROWS_WITH(build(cube(10.0), 5.1), "the cutoff of 5.1 m is longer than half of the periodic box, 5 m");
  CHECK_THROWS_WITH(build(cube(10.0), infinity),
                    "in a periodic box a law needs a cutoff, of at most half an edge, 5 m");
  sites.x[77][1] = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH(build({}, 1.0), Catch::Contains("not finite"));
  CHECK_THROWS_WITH(build({}, infinity), Catch::Contains("not finite"));
  sites.x[77] = vec(1, infinity, 1);
  CHECK_THROWS_WITH(build({}, 1.0), Catch::Contains("not finite"));
}

TEST_CASE("rows: a million particles at one position are refused at once") {
  Sites sites;
  sites.resize(1'000'000);
  std::fill_n(sites.x.begin(), sites.n, vec(1, 2, 3));
  std::fill(sites.family.begin(), sites.family.end(), 0u);
  std::fill(sites.kin.begin(), sites.kin.end(), Kin{});
  Workers workers;
  NeighbourList rows;
  const Families all = {0};
  CHECK_THROWS_WITH(
      rows.build(sites, {}, all, all, 2.5, 0.3, workers),
      Catch::StartsWith("1000000 particles have more than 536870912 pairs nearer than the cutoff of 2.5 m"));
  CHECK_THROWS_WITH(rows.build(sites, {}, all, all, infinity, 0.0, workers), Catch::Contains("without a cutoff"));
}

TEST_CASE("rows: nobody is also well") {
  check_rows(cases::random_sites({.count = 0}), {}, {0}, {0}, 1.0, 0.1);
  check_rows(cases::random_sites({.count = 0}), {}, {0}, {0}, infinity, 0.1);
  check_rows(cases::random_sites({.count = 1}), cube(10.0), {0}, {0}, 1.0, 0.1);
  check_rows(cases::random_sites({.count = 10}), {}, {0}, {1}, 1.0, 0.1);
}

TEST_CASE("rows: cell order brings neighbours together") {
  const Sites sites = cases::random_sites({.count = 4000, .edge = 20.0});
  const std::vector<std::uint32_t> order = cell_order({sites.x.data(), sites.n}, {}, 1.0);
  for (std::uint32_t i = 0; i < sites.n; i++) REQUIRE(order[i] == i);
}

TEST_CASE("skin: spent when something has moved more than half of it") {
  Sites sites = cases::random_sites();
  Skin skin;
  CHECK(skin.spent(sites));
  skin.restart(sites, 0.5);
  CHECK(!skin.spent(sites));
  sites.x[321] += vec(0, 0.2499, 0);
  CHECK(!skin.spent(sites));
  sites.x[321] += vec(0, 0.001, 0);
  CHECK(skin.spent(sites));
}

TEST_CASE("skin: the best one grows with what is moved in a step, and stays within half the cutoff") {
  double last = 0.0;
  for (const double speed : {0.0, 0.1, 1.0, 10.0, 1e3, 1e9, 1e200}) {
    const double width = best_skin(cases::random_sites({.speed = speed}), 0.005, 2.5);
    CHECK(width >= last);
    CHECK(width <= 1.25);
    last = width;
  }
}
