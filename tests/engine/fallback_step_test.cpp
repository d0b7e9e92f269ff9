// A chain of 10 m whose end is pulled to 15 m without mercy: it cannot hold, must share the misfit, and must recover.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "step/step.hpp"
#include "support/cases.hpp"
#include "support/watch.hpp"

using namespace pantin;

namespace {

/// Out at 5 m/s for 1 s, back at 5 m/s to `rest` [m], then still.
double pull(double time, double rest) { return time < 1 ? 10 + 5 * time : std::max(rest, 15 - 5 * (time - 1)); }

/// Gaps of the hinges between two links, [m].
std::pair<double, double> extreme_gaps(const World& world, const cases::Chain& chain) {
  double least = 1e300, largest = 0.0;
  for (std::size_t i = 0; i + 1 < chain.bodies.size(); i++) {
    const double gap = norm(position(world, chain.tails[i]) - position(world, chain.heads[i + 1]));
    least = std::min(least, gap);
    largest = std::max(largest, gap);
  }
  return {least, largest};
}

}  // namespace

TEST_CASE("overstretch: gaps are shared at the worst, and close when the end comes back") {
  const double step_length = GENERATE(1.0 / 60, 1.0 / 240), rest = GENERATE(5.0, 9.5);
  CAPTURE(step_length, rest);
  World world;
  world.settings.step = step_length;
  const cases::Chain chain = cases::add_chain(world);
  FollowDef follow;
  follow.target = [rest](double time) { return vec(pull(time, rest), 0, 0); };
  add_follow(world, chain.tails.back(), follow);

  const Watched out = watch(world, 1.0);
  CHECK(out.failure == "");
  CHECK(out.finite);
  const auto [least, largest] = extreme_gaps(world, chain);
  CHECK(largest >= 0.4);
  CHECK(largest - least <= 0.1 * largest);
  CHECK(world.error.hinge_gap >= largest * (1 - 1e-12));
  CHECK(world.stats.fallback_steps > 0);

  const Watched back = watch(world, 3.0);
  CHECK(back.failure == "");
  CHECK(back.finite);
  const Watched after = watch(world, 5.0);
  CHECK(after.failure == "");
  CHECK(after.finite);
  CHECK(after.gap <= 1e-10);
  CHECK(norm(position(world, chain.tails.back()) - vec(rest, 0, 0)) <= 1e-10);
}

TEST_CASE("overstretch: a chain torn from both ends by two followers stays whole") {
  World world;
  const cases::Chain chain = cases::add_chain(world, {.pinned = false});
  FollowDef left, right;
  left.target = [](double time) { return vec(-std::min(3 * time, 3.0) * (time < 2), 0, 0); };
  right.target = [](double time) { return vec(10 + std::min(3 * time, 3.0) * (time < 2) - (time >= 2), 0, 0); };
  add_follow(world, chain.heads.front(), left);
  add_follow(world, chain.tails.back(), right);
  const Watched torn = watch(world, 3.0);
  CHECK(torn.failure == "");
  CHECK(torn.finite);
  const Watched after = watch(world, 5.0);
  CHECK(after.failure == "");
  CHECK(after.gap <= 1e-10);
}
