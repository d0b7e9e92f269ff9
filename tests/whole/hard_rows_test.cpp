// Chains, heavy chains, a top and a ring at six step lengths, to within a factor of ten of the prototype's figures.
#include <catch2/catch.hpp>
#include <cmath>

#include "measure/measure.hpp"
#include "step/step.hpp"
#include "support/cases.hpp"
#include "support/endure.hpp"
#include "support/reference.hpp"

using namespace pantin;

namespace {

Scene chain_of(int links) {
  return [links](World& world) {
    cases::add_chain(world, {.links = links});
    return Action{};
  };
}

void check_exact(const World&, const Endured& run) {
  CHECK(run.energy <= 8e-10);
  CHECK(run.gap <= 1e-10);
  CHECK(run.fallbacks == 0);
}

/// Every `stride`-th of the six steps, over as many steps each.
void endure_long_chain(int links, int steps) {
  for (const double step : step_lengths)
    endure_at({&step, 1}, text("A chain of ", links), steps * step, 1.0, chain_of(links), check_exact);
}

}  // namespace

TEST_CASE("hard A: chains keep their hinges and their energy at every step length") {
  endure_at(step_lengths, "A chain of 1", 5.0, 1.0, chain_of(1), check_exact);
  endure_at(step_lengths, "A chain of 10", 5.0, 1.0, chain_of(10), check_exact);
  endure_at(step_lengths, "A chain of 100", 0.5, 1.0, chain_of(100), check_exact);
}

TEST_CASE("hard A: long chains do", "[slow]") {
  endure_at(step_lengths, "A chain of 100", 5.0, 1.0, chain_of(100), check_exact);
  endure_long_chain(1000, 300);
  endure_long_chain(10000, 30);
}

TEST_CASE("hard A: the end of a chain of ten is where the equations of motion say, at second order") {
  const reference::PlaneChain plane = reference::plane_chain(10);
  const Eigen::Vector2d position = reference::centre(plane, reference::advance(plane, 1.0, 100), 9);
  const auto error = [&](double step) {
    World world;
    world.settings.step = step;
    const cases::Chain chain = cases::add_chain(world);
    advance(world, 1.0);
    return norm(world.motion_of(chain.bodies.back()).x - vec(position.x(), position.y(), 0));
  };
  CHECK(error(1.0 / 60) <= 9.2e-3);
  CHECK(error(1.0 / 240) <= 5.8e-4);
  for (const double step : step_lengths) {
    CAPTURE(step);
    CHECK(error(step) <= 5.8e-4 * (240 * step) * (240 * step));
  }
}

TEST_CASE("hard B: heavy chains never fail at any step length") {
  const int links = GENERATE(10, 100);
  const double ratio = GENERATE(1e3, 1e6);
  const auto scene = [&](World& world) {
    cases::add_heavy_chain(world, links, ratio);
    return Action{};
  };
  endure_at(step_lengths, text("B heavy ", links, " ", ratio), links == 10 ? 2.0 : 0.5, 1.0, scene,
            [](const World&, const Endured& run) {
              CHECK(run.gap <= 2e-10);
              CHECK(run.energy <= 1e-9);
              CHECK(run.iterations <= 14.0);
              CHECK(run.fallbacks == 0);
            });
}

TEST_CASE(
    "hard B: a ball 50,000 times heavier than its 19 links is where the equations of motion say after two seconds") {
  const reference::PlaneChain plane = reference::heavy_plane_chain(19, 5e4);
  const Eigen::Vector2d position = reference::centre(plane, reference::advance(plane, 2.0, 2000), 19);
  const auto error = [&](double step) {
    World world;
    world.settings.step = step;
    const cases::Chain chain = cases::add_heavy_chain(world, 19, 5e4);
    advance(world, 2.0);
    return norm(world.motion_of(chain.bodies.back()).x - vec(position.x(), position.y(), 0));
  };
  CHECK(error(1.0 / 60) <= 4e-4);
  CHECK(error(1.0 / 120) <= 1e-4);
}

TEST_CASE("hard B: for five seconds", "[slow]") {
  for (const double ratio : {1e3, 1e6}) {
    const auto scene = [&](World& world) {
      cases::add_heavy_chain(world, 100, ratio);
      return Action{};
    };
    endure_at(step_lengths, text("B heavy 100 ", ratio), 5.0, 1.0, scene, [](const World&, const Endured& run) {
      CHECK(run.gap <= 2e-10);
      CHECK(run.fallbacks == 0);
    });
  }
}

TEST_CASE("hard C: a top that flips keeps energy and angular momentum to round-off at every step length") {
  for (const double step : step_lengths) {
    CAPTURE(step);
    World world;
    world.settings.step = step;
    const BodyId top = cases::add_top(world);
    const Vec3 start = angular_momentum(world, top);
    const double before = energy(world).total();
    advance(world, 100.0);
    const double round_off = step < 1.0 / 240 ? 1e-16 * static_cast<double>(world.steps) : 0.0;
    CHECK(world.failure == "");
    CHECK(norm(angular_momentum(world, top) - start) <= std::fmax(1e-12, round_off) * norm(start));
    CHECK(std::fabs(energy(world).total() - before) <= std::fmax(4e-12, round_off) * before);
  }
}

TEST_CASE("hard D: a ring of 24 is as exact as a chain at every step length") {
  const auto scene = [](World& world) {
    cases::add_ring(world, 24);
    return Action{};
  };
  endure_at(step_lengths, "D ring of 24", 5.0, 1.0, scene, check_exact);
}

TEST_CASE("hard A and D: what the projection takes without the energy return") {
  const auto lost = [](int which, double step) {
    World world;
    world.settings.step = step;
    world.settings.energy_return = false;
    which == 0 ? void(cases::add_chain(world)) : void(cases::add_ring(world, 24));
    advance(world, 5.0);
    CHECK(world.failure == "");
    return world.worst.energy;
  };
  CHECK(lost(0, 1.0 / 60) <= 1.1e-1);
  CHECK(lost(0, 1.0 / 240) <= 2.9e-3);
  CHECK(lost(1, 1.0 / 60) <= 1.0);
  CHECK(lost(1, 1.0 / 240) <= 6.7e-2);
}
