// A closed polygon of rods, one hinge nailed: a loop is as exact as a chain.
#include <catch2/catch.hpp>
#include <cmath>

#include "support/cases.hpp"
#include "support/watch.hpp"

using namespace pantin;

TEST_CASE("ring: keeps its hinges and its energy for 5 s") {
  const double step = GENERATE(1.0 / 60, 1.0 / 240);
  CAPTURE(step);
  World world;
  world.settings.step = step;
  cases::add_ring(world, 24);
  const Watched course = watch(world, 5.0);
  CHECK(course.failure == "");
  CHECK(course.finite);
  CHECK(course.gap <= 1e-10);
  CHECK(course.energy_error() <= 1e-9);
  CHECK(world.worst.energy == Approx(course.energy_error()).epsilon(1e-3).margin(1e-12));
  CHECK(world.stats.safe_steps == 0);
  CHECK(course.kinetic > 10.0);
}

TEST_CASE("ring: without the energy return the projection takes little") {
  World world;
  world.settings.energy_return = false;
  cases::add_ring(world, 24);
  const Watched course = watch(world, 5.0);
  CHECK(course.failure == "");
  CHECK(course.gap <= 1e-10);
  CHECK(course.energy_error() <= 1e-2);
}

TEST_CASE("ring: three rods are stiff, and swing as one body") {
  World world;
  const cases::Chain ring = cases::add_ring(world, 3);
  const double side = norm(world.motion_of(ring.bodies[0]).x - world.motion_of(ring.bodies[1]).x);
  const Watched course = watch(world, 5.0);
  CHECK(course.failure == "");
  CHECK(course.gap <= 1e-10);
  CHECK(course.energy_error() <= 1e-9);
  const double now = norm(world.motion_of(ring.bodies[0]).x - world.motion_of(ring.bodies[1]).x);
  CHECK(std::fabs(now - side) <= 1e-9);
}
