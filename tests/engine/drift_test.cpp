// Chains pulled too far, far hands with limits, hands that throw everything about.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <memory>

#include "choreography/hands.hpp"
#include "measure/measure.hpp"
#include "step/step.hpp"
#include "support/endure.hpp"
#include "support/hard_cases.hpp"

using namespace pantin;

namespace {

/// A hand that jumps to a random position within `reach` [m] every 20 steps, and takes hold of something else every 50.
Action thrower(World& world, std::shared_ptr<Random> random, std::vector<PointId> points, double reach) {
  const auto at = std::make_shared<Vec3>(zero3());
  const std::int32_t hand = add_hand(world, [at](double) { return *at; });
  return [&world, random, points, reach, at, hand] {
    if (world.steps % 20 == 0) *at = cases::vector_within(*random, reach);
    if (world.steps % 50 == 0) grab(world, hand, points[random->bits() % points.size()]);
  };
}

/// Masses of ± `decades` powers of ten, at one of the six steps.
void throw_tangle(const char* name, std::uint64_t seed, double decades, int loops) {
  const double step = step_lengths[seed % 4];
  const auto scene = [&](World& world) {
    const auto random = std::make_shared<Random>(Random{seed});
    const cases::Tangle tangle = cases::add_tangle(world, *random, 12, decades, loops);
    return thrower(world, random, tangle.points, 10.0);
  };
  endure_at({&step, 1}, text("thrown ", name, " ", seed, ", masses of ", decades, " decades"), 1000 * step, 1.0, scene);
}

}  // namespace

TEST_CASE("hard F: a chain of ten pulled to 15 m and back shares the misfit and closes again") {
  const auto scene = [](World& world) {
    const cases::Chain chain = cases::add_chain(world);
    const auto target = [](double t) { return vec(t < 1 ? 10 + 5 * t : std::max(5.0, 15 - 5 * (t - 1)), 0, 0); };
    add_follow(world, chain.tails.back(), {.target = target});
    const auto worst = std::make_shared<double>(0.0);
    return [&world, worst] {
      *worst = std::max(*worst, world.error.hinge_gap);
      CHECK(*worst <= 0.7);  // of 5 m, shared by ten hinges and the nail
    };
  };
  endure_at(step_lengths, "F pulled to 15 m", 3.5, 1.0, scene, [](const World& world, const Endured& run) {
    CHECK(run.fallbacks > 0);
    CHECK(run.last_gap <= 1e-10);
    CHECK(world.worst.hinge_gap >= 0.4);
  });
}

TEST_CASE("hard J: a hand at 50 m never pulls harder than its limit, at any step length") {
  const double limit = GENERATE(20.0, 200.0, 1e4);
  const auto scene = [limit](World& world) {
    const cases::Chain chain = cases::add_chain(world);
    const std::int32_t hand = add_hand(world, [](double) { return vec(50, 0, 0); });
    grab(world, hand, chain.tails.back(), limit);
    return [&world, limit] { CHECK(norm(world.constraints[world.hands[0].grab].force) <= limit * (1 + 1e-12)); };
  };
  endure_at(step_lengths, text("J hand with ", limit, " N"), 5.0, 1.0, scene, [](const World&, const Endured& run) {
    CHECK(run.gap <= 1e-10);
    CHECK(run.fallbacks == 0);
  });
}

TEST_CASE("hard: a hand throws a chain and a ring about for 1000 random steps") {
  for (const bool closed : {false, true})
    for (const double step : {1.0 / 60, 1.0 / 240, 1.0 / 1000}) {
      const auto scene = [closed](World& world) {
        const cases::Chain chain = closed ? cases::add_ring(world, 12) : cases::add_chain(world, {.links = 12});
        return thrower(world, std::make_shared<Random>(Random{11}), chain.tails, 10.0);
      };
      endure_at({&step, 1}, closed ? "thrown ring" : "thrown chain", 1000 * step, 1.0, scene);
    }
}

TEST_CASE("hard: hands throw random trees about for 1000 steps") {
  for (std::uint64_t seed = 1; seed <= 4; seed++)
    for (const double decades : {0.5, 3.0}) throw_tangle("tree", seed, decades, 0);
}

TEST_CASE("hard: hands throw random loops about for 1000 steps") {
  for (std::uint64_t seed = 5; seed <= 8; seed++)
    for (const double decades : {0.5, 3.0}) throw_tangle("loops", seed, decades, 3);
}

TEST_CASE("hard: hands throw random trees and loops of masses from 1e-6 to 1e6 kg about for 1000 steps", "[slow]") {
  for (std::uint64_t seed = 1; seed <= 4; seed++) throw_tangle("tree", seed, 6.0, 0);
  for (std::uint64_t seed = 5; seed <= 8; seed++) throw_tangle("loops", seed, 6.0, 3);
}
