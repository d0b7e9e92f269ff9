// Thousands of redundant rows: rotating squares, welds of three hinges, a hub of 500.
#include <catch2/catch.hpp>
#include <cmath>

#include "articulates/articulate.hpp"
#include "measure/measure.hpp"
#include "step/step.hpp"
#include "support/endure.hpp"
#include "support/hard_cases.hpp"

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
  CHECK(run.fallbacks + run.halved == 0);
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
      CHECK(run.fallbacks == 0);
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
      CHECK(run.fallbacks == 0);
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
    CHECK(run.fallbacks == 0);
    CHECK(run.gap <= 1e-10);
    CHECK(run.energy <= 1e-9);
  });
}

namespace {

/// A closed polygon of unit bars in the plane z = 0, each joined to the next by two hinges side by side, one of them
/// nailed: it moves in its plane, and each joint says twice that it stays there.
void add_ring_of_axes(World& world, int links) {
  const double pi = 3.14159265358979323846, height = 0.5 / std::tan(pi / links);
  std::vector<BodyId> bars;
  for (int i = 0; i < links; i++) {
    const double angle = 2 * pi * (i + 0.5) / links, along = 0.5 * angle + 0.25 * pi;
    BodyDef def;
    def.mass = 1.0;
    def.inertia = cases::rod_inertia(1, 1);
    def.at = vec(std::cos(angle), std::sin(angle), 0) * height;
    def.orientation = Quat{std::cos(along), 0, 0, std::sin(along)};
    for (const double z : {-0.1, 0.1})
      for (const double x : {-0.5, 0.5}) {
        PointDef point;
        point.at = vec(x, 0, z);
        def.points.push_back(point);
      }
    bars.push_back(add_body(world, def));
  }
  for (std::size_t i = 0; i < bars.size(); i++)
    for (const std::size_t side : {0u, 2u}) {
      const BodyId next = bars[(i + 1) % bars.size()];
      const PointId both[] = {cases::point_of(world, bars[i], side + 1), cases::point_of(world, next, side)};
      add_hinge(world, both);
    }
  add_nail(world, cases::point_of(world, bars[0], 0));
}

}  // namespace

TEST_CASE("hard: rings whose joints say twice what they say take three iterations a step, and pull no harder for it") {
  for (const int links : {4, 8}) {
    World world;
    add_ring_of_axes(world, links);
    const Endured run = endure(world, 3.0);
    CAPTURE(links);
    check_sound(run, 1.0);
    CHECK(run.fallbacks + run.halved == 0);
    CHECK(run.iterations <= 3.0);
    double hardest = 0.0;
    for (const Row& row : world.articulates[0]->rows) hardest = std::fmax(hardest, norm(row.f));
    CHECK(hardest <= 1e3);
  }
}
