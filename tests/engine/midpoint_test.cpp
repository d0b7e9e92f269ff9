// Rods on ball hinges, pinned at one end and let go from horizontal: gaps, energy, accuracy, order.
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "measure/measure.hpp"
#include "step/step.hpp"
#include "support/cases.hpp"
#include "support/reference.hpp"
#include "support/watch.hpp"

using namespace pantin;

namespace {

/// Distance of the last link's centre from the reference after 1 s, [m].
double error_at_one_second(int links, double step, bool energy_return) {
  World world;
  world.settings.step = step;
  world.settings.energy_return = energy_return;
  const cases::Chain chain = cases::add_chain(world, {.links = links});
  advance(world, 1.0);
  const reference::PlaneChain plane = reference::plane_chain(links);
  const Eigen::Vector2d position = reference::centre(plane, reference::advance(plane, 1.0, 100), links - 1);
  return norm(world.motion_of(chain.bodies.back()).x - vec(position.x(), position.y(), 0));
}

void keeps_hinges_and_energy(int links, double step) {
  CAPTURE(links, step);
  World world;
  world.settings.step = step;
  cases::add_chain(world, {.links = links});
  const Watched course = watch(world, 5.0);
  CHECK(course.failure == "");
  CHECK(course.finite);
  CHECK(course.gap <= 1e-10);
  CHECK(course.energy_error() <= 1e-9);
  CHECK(world.worst.hinge_gap == Approx(course.gap).margin(1e-14));
  CHECK(world.worst.energy == Approx(course.energy_error()).epsilon(1e-3).margin(1e-12));
  CHECK(world.largest_kinetic == Approx(course.kinetic).epsilon(1e-12));
  CHECK(world.stats.fallback_steps == 0);
}

}  // namespace

TEST_CASE("chain: 1, 10 and 100 links keep their hinges and their energy for 5 s") {
  const int links = GENERATE(1, 10, 100);
  const double step = GENERATE(1.0 / 60, 1.0 / 240, 1.0 / 1000);
  keeps_hinges_and_energy(links, step);
}

TEST_CASE("chain: 1000 links keep their hinges and their energy for 5 s", "[slow]") {
  const double step = GENERATE(1.0 / 60, 1.0 / 240, 1.0 / 1000);
  keeps_hinges_and_energy(1000, step);
}

TEST_CASE("chain: without the energy return the projection takes little") {
  World world;
  world.settings.energy_return = false;
  cases::add_chain(world);
  const Watched course = watch(world, 5.0);
  CHECK(course.failure == "");
  CHECK(course.gap <= 1e-10);
  CHECK(course.energy_error() <= 8e-5);
  const double now = std::fabs(energy(world).total() - world.start_energy) / world.largest_kinetic;
  CHECK(world.error.energy == Approx(now).margin(1e-12));
  CHECK(world.worst.energy == Approx(course.energy_error()).epsilon(1e-6));
}

TEST_CASE("chain: the end body is where the equations of motion say") {
  const bool energy_return = GENERATE(true, false);
  CAPTURE(energy_return);
  CHECK(error_at_one_second(10, 1.0 / 60, energy_return) <= 1.2e-3);
  CHECK(error_at_one_second(10, 1.0 / 240, energy_return) <= 7e-5);
}

TEST_CASE("chain: the error falls with the square of the step") {
  const bool energy_return = GENERATE(true, false);
  CAPTURE(energy_return);
  const std::vector<double> steps = {1.0 / 240, 1.0 / 480, 1.0 / 960, 1.0 / 1920};
  std::vector<double> errors;
  for (const double step : steps) errors.push_back(error_at_one_second(10, step, energy_return));
  CAPTURE(errors);
  CHECK(exponent(steps, errors) == Approx(2.0).margin(0.1));
}

TEST_CASE("chain: a free one keeps momentum and angular momentum to round-off") {
  const double step = GENERATE(1.0 / 60, 1.0 / 240);
  World world;
  world.settings.gravity = zero3();
  world.settings.step = step;
  const cases::Chain chain = cases::add_chain(world, {.pinned = false});
  kick(world, chain.bodies[2], vec(3, 5, -2), vec(2.2, 0.1, 0));
  kick(world, chain.bodies[7], vec(-1, -4, 6), vec(7.9, 0, 0.1));
  const Things all = everything(world);
  const Vec3 p = momentum(world, all), l = angular_momentum(world, all);
  double dp = 0.0, dl = 0.0;
  const Watched course = watch(world, 5.0, [&] {
    dp = std::fmax(dp, norm(momentum(world, all) - p));
    dl = std::fmax(dl, norm(angular_momentum(world, all) - l));
  });
  CHECK(course.failure == "");
  CHECK(course.gap <= 1e-10);
  CHECK(dp <= 1e-12 * norm(p));
  CHECK(dl <= 1e-12 * norm(l));
}

TEST_CASE("chain: the pin carries the weight of a chain that hangs still") {
  World world;
  BodyDef link;
  link.at = vec(0, -0.5, 0);
  link.orientation = {std::sqrt(0.5), 0, 0, -std::sqrt(0.5)};
  const BodyId upper = cases::add_rod_body(world, 1, 1, link);
  link.at = vec(0, -1.5, 0);
  const BodyId lower = cases::add_rod_body(world, 1, 1, link);
  const std::vector<PointId> joint = {cases::point_of(world, upper, 1), cases::point_of(world, lower, 0)};
  add_hinge(world, joint);
  const ConstraintId pin = add_nail(world, cases::point_of(world, upper, 0));
  advance(world, 1.0);
  CHECK(norm(world.constraints[pin].force - vec(0, 2 * 9.81, 0)) <= 1e-9 * 2 * 9.81);
  CHECK(norm(velocity(world, joint[1])) <= 1e-9);
}
