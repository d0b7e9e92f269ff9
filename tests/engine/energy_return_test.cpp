// Two particles on two massless rods.
#include <catch2/catch.hpp>
#include <cmath>
#include <utility>
#include <vector>

#include "step/step.hpp"
#include "support/cases.hpp"
#include "support/reference.hpp"
#include "support/watch.hpp"

using namespace pantin;

namespace {

/// Angles from the downward vertical, [rad].
std::pair<double, double> angles(const World& world, const cases::DoublePendulum& pendulum) {
  const Vec3 a = position(world, pendulum.inner), b = position(world, pendulum.outer) - a;
  return {std::atan2(a[0], -a[1]), std::atan2(b[0], -b[1])};
}

/// Largest error of the two angles at `time` [s], [rad].
double angle_error(double time, double step) {
  World world;
  world.settings.step = step;
  world.settings.energy_return = false;
  const cases::DoublePendulum pendulum = cases::add_double_pendulum(world);
  advance(world, time);
  const auto [a, b] = angles(world, pendulum);
  const reference::State exact = reference::double_pendulum(time, 200);
  return std::fmax(std::fabs(a - exact(0)), std::fabs(b - exact(1)));
}

}  // namespace

TEST_CASE("double pendulum: the angles are those of the equations of motion") {
  World world;
  world.settings.step = 1.0 / 1000;
  world.settings.energy_return = false;
  const cases::DoublePendulum pendulum = cases::add_double_pendulum(world);
  advance(world, 1.0);
  const auto [a1, b1] = angles(world, pendulum);
  CHECK(std::fabs(a1 - -0.62508769980639) <= 3e-5);
  CHECK(std::fabs(b1 - -1.03458508568001) <= 3e-5);
  advance(world, 2.0);
  const auto [a2, b2] = angles(world, pendulum);
  CHECK(std::fabs(a2 - -0.48297153425175) <= 3e-5);
  CHECK(std::fabs(b2 - -1.32404871230236) <= 3e-5);
}

TEST_CASE("double pendulum: the reference has the angles known to 14 digits") {
  const reference::State one = reference::double_pendulum(1.0, 200), two = reference::double_pendulum(2.0, 400);
  CHECK(std::fabs(one(0) - -0.62508769980639) <= 1e-11);
  CHECK(std::fabs(one(1) - -1.03458508568001) <= 1e-11);
  CHECK(std::fabs(two(0) - -0.48297153425175) <= 1e-11);
  CHECK(std::fabs(two(1) - -1.32404871230236) <= 1e-11);
}

TEST_CASE("double pendulum: the error falls with the square of the step") {
  const double time = GENERATE(1.0, 2.0);
  CAPTURE(time);
  const std::vector<double> steps = {1.0 / 500, 1.0 / 1000, 1.0 / 2000, 1.0 / 4000};
  std::vector<double> errors;
  for (const double step : steps) errors.push_back(angle_error(time, step));
  CAPTURE(errors);
  CHECK(exponent(steps, errors) == Approx(2.0).margin(0.1));
}

TEST_CASE("double pendulum: rods keep their length, and energy stays with the return") {
  const double step = GENERATE(1.0 / 60, 1.0 / 240);
  CAPTURE(step);
  World world;
  world.settings.step = step;
  const cases::DoublePendulum pendulum = cases::add_double_pendulum(world);
  double stretch = 0.0;
  const Watched course = watch(world, 5.0, [&] {
    const Vec3 a = position(world, pendulum.inner), b = position(world, pendulum.outer);
    stretch = std::fmax(stretch, std::fmax(std::fabs(norm(a) - 1), std::fabs(norm(b - a) - 1)));
  });
  CHECK(course.failure == "");
  CHECK(stretch <= 1e-10);
  CHECK(world.worst.constraint == Approx(stretch).margin(1e-14));
  CHECK(course.energy_error() <= 1e-9);
}

// Each step's projection acts along the rod of that step: what is carried over must turn with it.
TEST_CASE("double pendulum: without the return the projection takes energy of fourth order") {
  std::vector<double> steps = {1.0 / 120, 1.0 / 240, 1.0 / 480}, errors;
  for (const double h : steps) {
    World world;
    world.settings.step = h;
    world.settings.energy_return = false;
    cases::add_double_pendulum(world);
    errors.push_back(watch(world, 1.0).energy_error());
  }
  CAPTURE(errors);
  CHECK(errors[1] <= 1e-7);
  CHECK(exponent(steps, errors) >= 3.5);
}
