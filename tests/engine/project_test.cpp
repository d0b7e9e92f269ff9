// A closed polygon of rods, one hinge nailed: a loop is as exact as a chain.
#include <catch2/catch.hpp>
#include <cmath>

#include "step/step.hpp"
#include "support/cases.hpp"
#include "support/reference.hpp"
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
  CHECK(world.stats.fallback_steps == 0);
  CHECK(course.kinetic > 10.0);
}

TEST_CASE("ring: without the energy return the projection takes little") {
  World world;
  world.settings.energy_return = false;
  cases::add_ring(world, 24);
  const Watched course = watch(world, 5.0);
  CHECK(course.failure == "");
  CHECK(course.gap <= 1e-10);
  CHECK(course.energy_error() <= 3e-3);
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

TEST_CASE("ring: is where the equations of motion say, to second order") {
  const reference::PlaneChain plane = reference::plane_ring(24);
  const Eigen::Vector2d exact = reference::centre(plane, reference::advance(plane, 1.0, 100), 11);
  double errors[2];
  for (const int k : {0, 1}) {
    World world;
    world.settings.step = 1.0 / (120 << k);
    const cases::Chain ring = cases::add_ring(world, 24);
    const Vec3 top = position(world, ring.heads[6]);
    advance(world, 1.0);
    errors[k] = norm(world.motion_of(ring.bodies[17]).x - top - vec(exact.x(), exact.y(), 0));
  }
  CHECK(errors[0] <= 1e-3);
  CHECK(errors[0] / errors[1] == Approx(4.0).margin(1.0));
}
