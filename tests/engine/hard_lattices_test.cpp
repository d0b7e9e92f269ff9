// Thousands of redundant rows: rotating squares, welds of three hinges, a hub of 500.
#include <catch2/catch.hpp>
#include <cmath>

#include "step.hpp"
#include "support/endure.hpp"
#include "support/hard_cases.hpp"
#include "world/measure.hpp"

using namespace pantin;

namespace {

/// Squares that a corner is dragged open of, at 0.02 m/s for each square of a side.
Scene dragged_squares(int side, Plane plane = {}) {
  return [side, plane](World& world) {
    set_plane(world, plane);
    const cases::Squares squares = cases::add_squares(world, side, 0.2);
    const Vec3 start = position(world, squares.corner), speed = squares.away * (0.02 * side);
    add_follow(world, squares.corner, {.target = [=](double t) { return start + speed * t; }});
    return Action{};
  };
}

void check_lattice(const World& world, const Endured& run) {
  double out_of_plane = 0.0;
  for (const BodyId body : world.bodies.ids())
    out_of_plane = std::fmax(out_of_plane, std::fabs(world.motion_of(body).x[2]));
  CHECK(run.gap <= 3e-11);
  CHECK(out_of_plane <= 1e-12);
  CHECK(run.safe + run.halved == 0);
}

void check_small_lattice(const World& world, const Endured& run) {
  check_lattice(world, run);
  CHECK(run.iterations <= 2.1);  // with those of the first step
}

}  // namespace

TEST_CASE("hard E: rotating squares are dragged open at every step length, in two iterations a step") {
  endure_at(step_lengths, "E squares 4 x 4", 2.0, 1.0, dragged_squares(4), check_small_lattice);
  for (const double step : step_lengths)
    endure_at({&step, 1}, "E squares 16 x 16", 20 * step, 1.0, dragged_squares(16), check_small_lattice);
}

TEST_CASE("hard E: in a plane they never leave it") {
  const auto check = [](const World& world, const Endured& run) {
    check_small_lattice(world, run);
    for (const BodyId body : world.bodies.ids()) CHECK(world.motion_of(body).x[2] == 0.0);
  };
  for (const double step : step_lengths)
    endure_at({&step, 1}, "E squares 16 x 16 in a plane", 20 * step, 1.0, dragged_squares(16, {2}), check);
}

TEST_CASE("hard E: a planar lattice of 32 x 32 squares in space is dragged open", "[slow]") {
  for (const double step : step_lengths)
    endure_at({&step, 1}, "E squares 32 x 32", 60 * step, 1.0, dragged_squares(32),
              [](const World& world, const Endured& run) {
                check_lattice(world, run);
                CHECK(run.iterations <= 3.1);
              });
}

TEST_CASE("hard G: a cantilever of 50 rods, each welded by three hinges, does not sag at any step length") {
  for (const double step : step_lengths) {
    const double time = std::fmin(5.0, 1000 * step);
    PointId tip;
    const auto scene = [&](World& world) {
      tip = cases::add_cantilever(world, 50);
      return Action{};
    };
    endure_at({&step, 1}, "G cantilever", time, 1.0, scene, [&](const World& world, const Endured& run) {
      CHECK(std::fabs(position(world, tip)[1]) <= 1e-8);
      CHECK(run.gap <= 1e-10);
      CHECK(run.safe == 0);
    });
  }
}

TEST_CASE("hard: a body of 500 hinges", "[slow]") {
  const auto scene = [](World& world) {
    cases::add_hub(world, 500);
    return Action{};
  };
  for (const double step : step_lengths)
    endure_at({&step, 1}, "hub of 500", 3 * step, 1.0, scene, [](const World&, const Endured& run) {
      CHECK(run.safe == 0);
      CHECK(run.gap <= 1e-10);
      CHECK(run.energy <= 1e-9);
    });
}

TEST_CASE("hard: a body of 40 hinges swings for seconds at every step length") {
  const auto scene = [](World& world) {
    cases::add_hub(world, 40);
    return Action{};
  };
  endure_at(step_lengths, "hub of 40", 0.5, 1.0, scene, [](const World&, const Endured& run) {
    CHECK(run.safe == 0);
    CHECK(run.gap <= 1e-10);
    CHECK(run.energy <= 1e-9);
  });
}
