// Mass ratios along chains, and other things out of all proportion: spin, gravity, steps, start states.
#include <catch2/catch.hpp>
#include <cmath>

#include "measure/measure.hpp"
#include "step/step.hpp"
#include "support/endure.hpp"
#include "support/hard_cases.hpp"

using namespace pantin;

namespace {

Scene mixed_chain(std::uint64_t seed, double decades) {
  return [=](World& world) {
    Random random{seed};
    cases::add_mixed_chain(world, 20, random, decades);
    return Action{};
  };
}

}  // namespace

TEST_CASE("hard: chains with neighbours up to a million times heavier, in random order, at every step length") {
  for (std::uint64_t seed = 1; seed <= 4; seed++)
    endure_at(step_lengths, text("masses 1e-3 to 1e3 kg, ", seed), 0.5, 1.0, mixed_chain(seed, 3),
              [](const World&, const Endured& run) {
                CHECK(run.fallbacks == 0);
                CHECK(run.energy <= 1e-9);
              });
}

TEST_CASE("hard: chains of masses from 1e-6 to 1e6 kg in random order, at every step length") {
  for (std::uint64_t seed = 1; seed <= 3; seed++)
    endure_at(step_lengths, text("masses 1e-6 to 1e6 kg, ", seed), 0.25, 1.0, mixed_chain(seed, 6),
              [](const World&, const Endured& run) { CHECK(run.last_gap <= 1e-8); });
}

TEST_CASE("hard: a single rod spun at 1e4 rad/s keeps its energy at any step") {
  for (const double step : {1.0 / 10, 1.0 / 60, 1.0 / 120, 1.0 / 240, 1.0 / 480, 1.0 / 1000, 1.0 / 4000}) {
    BodyId rod;
    const auto scene = [&](World& world) {
      rod = cases::add_rod_body(world, 1, 1);
      set_spin(world, rod, vec(6e3, 0, 8e3));
      return Action{};
    };
    World still;
    const BodyId other = cases::add_rod_body(still, 1, 1);
    set_spin(still, other, vec(6e3, 0, 8e3));
    const Vec3 start = angular_momentum(still, other);
    endure_at({&step, 1}, "rod at 1e4 rad/s", 1.0, 1.0, scene, [&](const World& world, const Endured& run) {
      CHECK(run.energy <= 1e-11);
      const Motion& m = world.motion_of(rod);
      CHECK(norm(angular_momentum(world, rod) - start - cross(m.x, m.p)) <= 1e-11 * norm(start));
    });
  }
}

TEST_CASE("hard: a rod on a nail spun at 1e4 rad/s") {
  const auto scene = [](World& world) {
    const BodyId rod = cases::add_rod_body(world, 1, 1);
    set_spin(world, rod, vec(0, 0, 1e4));
    set_velocity(world, rod, vec(0, 5e3, 0));
    add_nail(world, cases::point_of(world, rod, 0));
    return Action{};
  };
  endure_at(step_lengths, "rod on a nail at 1e4 rad/s", 1.0, 1.0, scene,
            [](const World&, const Endured& run) { CHECK(run.energy <= 1e-6); });
}

TEST_CASE("hard: a chain in gravity of 1e6 m/s^2") {
  const auto scene = [](World& world) {
    world.settings.gravity = vec(0, -1e6, 0);
    cases::add_chain(world);
    return Action{};
  };
  endure_at(step_lengths, "gravity of 1e6", 1.0, 1.0, scene,
            [](const World&, const Endured& run) { CHECK(run.last_gap <= 1e-8); });
}

TEST_CASE("hard: steps of a tenth of a second") {
  const double step = 0.1;
  const auto scene = [](int which) {
    return [which](World& world) {
      if (which == 0) cases::add_chain(world);
      if (which == 1) cases::add_chain(world, {.links = 100});
      if (which == 2) cases::add_ring(world, 24);
      if (which == 3) cases::add_heavy_chain(world, 10, 1e6);
      return Action{};
    };
  };
  const char* names[] = {"chain of 10", "chain of 100", "ring of 24", "heavy chain"};
  for (int which = 0; which < 4; which++)
    endure_at({&step, 1}, text(names[which], " at 1/10 s"), 20.0, 1.0, scene(which),
              [](const World&, const Endured& run) { CHECK(run.last_gap <= 1e-8); });
}

TEST_CASE("hard: start states with gaps are closed in one step, and move on as if nothing had been") {
  for (const double gap : {1e-3, 0.1, 10.0}) {
    const auto scene = [gap](World& world) {
      const cases::Chain chain = cases::add_chain(world);
      set_position(world, chain.bodies[5], vec(5.5, 0, gap));
      return Action{};
    };
    endure_at(step_lengths, text("gap of ", gap, " m"), 1.0, 1.0, scene, [](const World&, const Endured& run) {
      CHECK(run.fallbacks == 1);
      CHECK(run.last_gap <= 1e-10);
    });
  }
}

TEST_CASE("hard: start states with everything out of place") {
  for (std::uint64_t seed = 1; seed <= 6; seed++) {
    const double step = step_lengths[seed - 1];
    const auto scene = [&](World& world) {
      Random random{seed};
      const cases::Tangle tangle = cases::add_tangle(world, random, 12, 2.0, seed % 2 == 0 ? 0 : 2);
      for (const BodyId body : tangle.bodies)
        set_position(world, body, world.motion_of(body).x + cases::vector_within(random, 3.0));
      return Action{};
    };
    endure_at({&step, 1}, text("all out of place ", seed), 100 * step, 1.0, scene,
              [](const World&, const Endured& run) { CHECK(run.last_gap <= 1e-8); });
  }
}
