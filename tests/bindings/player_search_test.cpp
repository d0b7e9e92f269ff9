// Where a function is largest, in few askings.
#include "player/sweep/search.hpp"

#include <catch2/catch.hpp>
#include <deque>
#include <set>

#include "base/lanes.hpp"
#include "support/search_cases.hpp"

using namespace pantin;
using namespace pantin::support;
using player::Search;

namespace {

std::string exact(const CubePoint& at) {
  std::string key;
  for (const double x : at) key += std::to_string(1e9 * x) + " ";
  return key;
}

/// All points that are asked, by their numbers, where up to `ahead` values are waited for at once and come in another order.
std::map<std::uint64_t, CubePoint> asked_points(const Searched& function, std::uint64_t points, std::size_t ahead) {
  Search search(function.dimensions, points, exact);
  const CubePoint place = place_of(function, 1);
  std::map<std::uint64_t, CubePoint> all;
  std::deque<Search::Asked> waiting;
  for (Random random{1, 0};;) {
    while (waiting.size() < ahead)
      if (const auto asked = search.ask())
        waiting.push_back(*asked);
      else
        break;
    if (waiting.empty()) return all;
    const auto next = waiting.begin() + static_cast<long>(random.uniform() * static_cast<double>(waiting.size()));
    all[next->number] = next->at;
    search.tell(next->number, function.value(next->at, place));
    waiting.erase(next);
  }
}

}  // namespace

TEST_CASE("search: 200 points find what is largest where a hypercube of as many hardly does") {
  for (const Searched& function : searched) {
    CAPTURE(function.name);
    int by_search = 0, by_hypercube = 0;
    for (std::uint64_t trial = 1; trial <= 20; trial++) {
      by_search += points_needed(function, trial, 200) <= 200 ? 1 : 0;
      by_hypercube += points_of_hypercube(function, trial, 200) <= 200 ? 1 : 0;
    }
    CHECK(by_search >= 16);
    CHECK(by_hypercube <= 16);
  }
}

TEST_CASE("search: its points follow from the values, not from when they come") {
  for (const Searched& function : searched) {
    CAPTURE(function.name);
    const auto one = asked_points(function, 150, 1);
    CHECK(one.size() == 150);
    CHECK(asked_points(function, 150, 2) == one);
    CHECK(asked_points(function, 150, 1000) == one);
  }
}

TEST_CASE("search: it stays within the cube, and asks all its points where all are as bad") {
  for (const double value : {0.0, failed_case, infinity, 1e308}) {
    CAPTURE(value);
    Search search(3, 150, exact);
    std::uint64_t asked = 0;
    for (; const auto next = search.ask(); asked++) {
      for (const double x : next->at) CHECK((x >= 0.0 && x <= 1.0));
      search.tell(next->number, value);
    }
    CHECK(asked == 150);
  }
}

TEST_CASE("search: few points, and one dimension, are enough to begin with") {
  for (const std::size_t dimensions : {1u, 2u, 7u})
    for (const std::uint64_t points : {1u, 2u, 3u, 4u, 5u, 20u}) {
      CAPTURE(dimensions, points);
      Search search(dimensions, points, exact);
      std::set<std::uint64_t> numbers;
      while (const auto next = search.ask()) {
        numbers.insert(next->number);
        search.tell(next->number, -next->at[0]);
      }
      CHECK(numbers.size() == points);
      CHECK(*numbers.rbegin() == points - 1);
    }
}

TEST_CASE("search: points that are one are asked once, and it ends where there are no others") {
  const auto thirds = [](const CubePoint& at) { return std::to_string(static_cast<int>(std::min(2.0, 3.0 * at[0]))); };
  Search search(1, 100, thirds);
  std::multiset<std::string> keys;
  while (const auto next = search.ask()) {
    keys.insert(thirds(next->at));
    search.tell(next->number, next->at[0]);
  }
  CHECK(keys == std::multiset<std::string>{"0", "1", "2"});
}
