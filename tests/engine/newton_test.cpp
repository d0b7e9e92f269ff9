// A chain of unit rods with a sphere up to a million times heavier at its end.
#include <catch2/catch.hpp>

#include "step/step.hpp"
#include "support/cases.hpp"
#include "support/reference.hpp"
#include "support/watch.hpp"

using namespace pantin;

TEST_CASE("heavy: no mass ratio needs the fallback step") {
  const int links = GENERATE(10, 100);
  const double ratio = GENERATE(1e3, 1e6), step = GENERATE(1.0 / 60, 1.0 / 240);
  CAPTURE(links, ratio, step);
  World world;
  world.settings.step = step;
  cases::add_heavy_chain(world, links, ratio);
  const Watched course = watch(world, 5.0);
  CHECK(course.failure == "");
  CHECK(course.finite);
  CHECK(world.stats.fallback_steps == 0);
  CHECK(course.gap <= 1e-9);
  CHECK(course.energy_error() <= 1e-9);
  const double iterations = static_cast<double>(world.stats.newton_iterations) / static_cast<double>(world.steps);
  CHECK(iterations <= 12.0);
}

TEST_CASE("heavy: the sphere is where the equations of motion say") {
  const reference::PlaneChain plane = reference::heavy_plane_chain(10, 1e3);
  const Eigen::Vector2d position = reference::centre(plane, reference::advance(plane, 1.0, 500), 10);
  World world;
  world.settings.step = 1.0 / 60;
  const cases::Chain chain = cases::add_heavy_chain(world, 10, 1e3);
  advance(world, 1.0);
  CHECK(norm(world.motion_of(chain.bodies.back()).x - vec(position.x(), position.y(), 0)) <= 1e-3);
}
