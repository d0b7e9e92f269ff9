// Pairs of shapes that are near each other, against all pairs.
#include "contacts/broad_phase.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

#include "base/random.hpp"
#include "support/allocations.hpp"

using namespace pantin;

namespace {

using Entry = BroadPhase::Entry;
using Pairs = std::vector<BroadPhase::Pair>;

Bounds cube(Vec3 centre, double half) {
  const Vec3 d = vec(half, half, half);
  return {centre - d, centre + d};
}

Vec3 random_point(Random& random, double extent) {
  return vec(random.uniform() - 0.5, random.uniform() - 0.5, random.uniform() - 0.5) * extent;
}

/// Some shapes, of which a few are huge, a few rest, and one is a half space.
std::vector<Entry> random_entries(Random& random, std::uint32_t count) {
  std::vector<Entry> entries;
  for (std::uint32_t i = 0; i < count; i++) {
    const double half = i % 50 == 7 ? 5.0 : i % 10 == 3 ? 1e-3 : 0.3;
    entries.push_back({cube(random_point(random, 10.0), half), i, i % 4 != 0});
  }
  entries.push_back({{vec(-infinity, -infinity, -infinity), vec(infinity, -4.0, infinity)}, count, false});
  return entries;
}

Pairs all_pairs(const std::vector<Entry>& entries) {
  Pairs pairs;
  for (const Entry& a : entries)
    for (const Entry& b : entries)
      if (a.shape < b.shape && (a.moves || b.moves) && (a.owner != b.owner || a.owner == BoundsTree::none) &&
          overlap(a.exact, b.exact))
        pairs.push_back({a.shape, b.shape});
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

Pairs pairs_of(BroadPhase& broad_phase) {
  const auto pairs = broad_phase.pairs();
  return {pairs.begin(), pairs.end()};
}

}  // namespace

TEST_CASE("broad phase: its pairs are those among all pairs over a hundred moves") {
  Random random;
  std::vector<Entry> entries = random_entries(random, 300);
  BroadPhase broad_phase;
  for (int move = 0; move < 100; move++) {
    for (Entry& entry : entries) {
      if (entry.moves && random.uniform() < 0.1) entry.owner = static_cast<std::uint32_t>(20.0 * random.uniform());
      if (entry.moves) {
        const Vec3 way = random_point(random, move % 10 == 0 ? 3.0 : 0.02);
        entry.exact = {entry.exact.low + way, entry.exact.high + way};
      }
      broad_phase.put(entry, 0.05);
    }
    REQUIRE(pairs_of(broad_phase) == all_pairs(entries));
  }
}

TEST_CASE("broad phase: pairs do not depend on the order in which shapes came, went and came again") {
  Random random{.seed = 2};
  const std::vector<Entry> entries = random_entries(random, 200);
  BroadPhase forwards, backwards;
  for (const Entry& entry : entries) forwards.put(entry, 0.1);
  for (auto entry = entries.rbegin(); entry != entries.rend(); ++entry) {
    backwards.put(*entry, 0.02);
    if (entry->shape % 3 == 0) backwards.remove(entry->shape);
  }
  backwards.pairs();
  for (const Entry& entry : entries) backwards.put(entry, 0.3);
  CHECK(pairs_of(forwards) == pairs_of(backwards));
}

TEST_CASE("broad phase: what is all in one place is told with the place, and once it is gone all is well") {
  BroadPhase broad_phase;
  for (std::uint32_t i = 0; i < 2000; i++) broad_phase.put({cube(vec(3, 0, 0), 1.0), i, true}, 0.1);
  CHECK_THROWS_WITH(broad_phase.pairs(), Catch::Contains("too much touches in one place, about (3, 0, 0) m"));
  for (std::uint32_t i = 2; i < 2000; i++) broad_phase.put({cube(vec(3, 4.0 * i, 0), 1.0), i, true}, 0.1);
  CHECK(pairs_of(broad_phase) == Pairs{{0, 1}});
}

TEST_CASE("broad phase: what is taken out is in no pair, in no box and on no way") {
  BroadPhase broad_phase;
  for (std::uint32_t i = 0; i < 3; i++) broad_phase.put({cube(vec(0.1 * i, 0, 0), 1.0), i, true}, 0.1);
  CHECK(broad_phase.pairs().size() == 3);
  broad_phase.remove(1);
  broad_phase.remove(1);
  broad_phase.remove(77);
  CHECK(pairs_of(broad_phase) == Pairs{{0, 2}});
  broad_phase.in_box(cube(zero3(), 1.0), [](std::uint32_t shape) { CHECK(shape != 1); });
  broad_phase.along(cube(zero3(), 1.0), vec(1, 0, 0), [](std::uint32_t shape) { CHECK(shape != 1); });
}

TEST_CASE("broad phase: what begins to move has pairs with what rests, what comes to rest has none") {
  BroadPhase broad_phase;
  broad_phase.put({cube(zero3(), 1.0), 0, false}, 0.1);
  broad_phase.put({cube(zero3(), 1.0), 1, false}, 0.1);
  CHECK(broad_phase.pairs().empty());
  broad_phase.put({cube(zero3(), 1.0), 1, true}, 0.1);
  CHECK(pairs_of(broad_phase) == Pairs{{0, 1}});
  broad_phase.put({cube(zero3(), 1.0), 1, false}, 0.1);
  CHECK(broad_phase.pairs().empty());
}

TEST_CASE("broad phase: boxes and ways meet what they meet among all") {
  Random random{.seed = 3};
  const std::vector<Entry> entries = random_entries(random, 300);
  BroadPhase broad_phase;
  for (const Entry& entry : entries) broad_phase.put(entry, 0.2);
  for (int trial = 0; trial < 50; trial++) {
    const Bounds box = cube(random_point(random, 10.0), 0.5);
    const Vec3 way = trial % 5 == 0 ? vec(0, 4, 0) : random_point(random, 8.0);
    std::vector<std::uint32_t> met, on_way, expected_met, expected_on_way;
    broad_phase.in_box(box, [&](std::uint32_t shape) { met.push_back(shape); });
    broad_phase.along(box, way, [&](std::uint32_t shape) { on_way.push_back(shape); });
    for (const Entry& entry : entries) {
      if (overlap(entry.exact, box)) expected_met.push_back(entry.shape);
      if (meets_on_way(box, way, entry.exact)) expected_on_way.push_back(entry.shape);
    }
    std::sort(met.begin(), met.end());
    std::sort(on_way.begin(), on_way.end());
    REQUIRE(met == expected_met);
    REQUIRE(on_way == expected_on_way);
  }
}

TEST_CASE("broad phase: a swept box meets what one of many boxes on its way meets") {
  Random random{.seed = 4};
  int met = 0;
  for (int trial = 0; trial < 300; trial++) {
    const Bounds box = cube(random_point(random, 4.0), 0.3), other = cube(random_point(random, 4.0), 0.5);
    const Vec3 way = random_point(random, 6.0);
    bool sampled = false;
    for (int i = 0; i <= 1000; i++) {
      const Vec3 moved = way * (i / 1000.0);
      sampled = sampled || overlap({box.low + moved, box.high + moved}, other);
    }
    // Between two of the samples it may graze a corner.
    const Vec3 little = vec(0.01, 0.01, 0.01);
    if (sampled) CHECK(meets_on_way(box, way, other));
    if (!sampled) CHECK(!meets_on_way(box, way, {other.low + little, other.high - little}));
    met += sampled ? 1 : 0;
  }
  CHECK(met > 30);
}

TEST_CASE("broad phase: six hundred shapes in one place are a pair each with each") {
  BroadPhase broad_phase;
  for (std::uint32_t i = 0; i < 600; i++) broad_phase.put({cube(zero3(), 1.0), i, true}, 0.1);
  const auto pairs = broad_phase.pairs();
  CHECK(pairs.size() == 600 * 599 / 2);
  CHECK(std::is_sorted(pairs.begin(), pairs.end()));
}

TEST_CASE("broad phase: shapes along a line, come in order, are found as fast as others") {
  BroadPhase broad_phase;
  const std::uint32_t count = 4000;
  for (std::uint32_t i = 0; i < count; i++) broad_phase.put({cube(vec(i, 0, 0), 0.6), i, true}, 0.01);
  CHECK(broad_phase.pairs().size() == count - 1);
  int found = 0;
  broad_phase.in_box(cube(vec(100, 0, 0), 0.1), [&](std::uint32_t) { found++; });
  CHECK(found == 1);
}

TEST_CASE("broad phase: a warm step asks for no memory") {
  Random random{.seed = 5};
  std::vector<Entry> entries = random_entries(random, 300);
  BroadPhase broad_phase;
  const auto step = [&](double way) {
    for (Entry& entry : entries) {
      entry.exact = {entry.exact.low + vec(way, 0, 0), entry.exact.high + vec(way, 0, 0)};
      broad_phase.put(entry, 0.05);
    }
    broad_phase.pairs();
  };
  for (int i = 0; i < 50; i++) step(i % 2 == 0 ? 0.2 : -0.2);
  const std::uint64_t before = allocations();
  for (int i = 0; i < 10; i++) step(i % 2 == 0 ? 0.2 : -0.2);
  CHECK(allocations() == before);
}
