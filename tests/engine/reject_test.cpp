// scene.accuracy: sub-steps by a measured local error.
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "articulates/articulate.hpp"
#include "base/parallel.hpp"
#include "edit/edit.hpp"
#include "measure/measure.hpp"
#include "step/step.hpp"
#include "support/cases.hpp"
#include "support/kepler.hpp"
#include "support/reference.hpp"

using namespace pantin;
using Catch::Contains;

namespace {

/// Distance of the end body of chain(10) from the reference at 1 s, [m].
double error_with(std::optional<double> accuracy, double step_length) {
  World world;
  world.settings.step = step_length;
  const cases::Chain chain = cases::add_chain(world);
  set_accuracy(world, accuracy);
  advance(world, 1.0);
  CHECK(world.failure == "");
  CHECK(world.worst.hinge_gap <= 1e-10);
  const reference::PlaneChain plane = reference::plane_chain(10);
  const Eigen::Vector2d position = reference::centre(plane, reference::advance(plane, 1.0, 100), 9);
  return norm(world.motion_of(chain.bodies.back()).x - vec(position.x(), position.y(), 0));
}

BodyId add_wheel(World& world) {
  world.settings.gravity = zero3();
  BodyDef wheel;
  wheel.mass = 1.0;
  wheel.inertia = diagonal(vec(1, 1.5, 2));
  wheel.spin = vec(0, 0, 50);
  return add_body(world, wheel);
}

/// Angle that a wheel of 50 rad/s lacks after 1 s, [rad].
double lag(World& world, BodyId wheel) {
  double turned = 0.0;
  for (Quat last = orientation(world, wheel); world.time < 1.0 - 1e-9;) {
    step(world);
    const Quat now = orientation(world, wheel), turn = conjugate(last) * now;
    turned += 2.0 * std::atan2(turn.z, turn.w);
    last = now;
  }
  return std::fabs(turned - 50.0);
}

}  // namespace

TEST_CASE("accuracy: a chain has the wanted error per second") {
  const double step_length = GENERATE(1.0 / 60, 1.0 / 240);
  CAPTURE(step_length);
  CHECK(error_with(1e-3, step_length) <= 1e-3);
  CHECK(error_with(1e-5, step_length) <= 1e-5);
}

TEST_CASE("accuracy: a fast wheel is seen, alone and on an axle") {
  World fixed;
  CHECK(lag(fixed, add_wheel(fixed)) == Approx(50.0 * std::pow(50.0 / 240, 4) / 120).epsilon(0.03));
  World alone;
  const BodyId wheel = add_wheel(alone);
  set_accuracy(alone, 1e-6);
  CHECK(lag(alone, wheel) <= 1e-6);
  CHECK(most_sub_steps(alone).count > 1);
  World nailed;
  const BodyId turning = add_wheel(nailed);
  for (const double z : {-1.0, 1.0}) {
    PointDef end;
    end.at = vec(0, 0, z);
    add_nail(nailed, add_point(nailed, turning, end));
  }
  set_accuracy(nailed, 1e-3);
  CHECK(lag(nailed, turning) <= 1e-2);
  CHECK(most_sub_steps(nailed).count > 1);
  World held;  // a tree, which takes steps of its own
  const BodyId centred = add_wheel(held);
  add_nail(held, add_point(held, centred, {}));
  set_accuracy(held, 1e-6);
  CHECK(lag(held, centred) <= 1e-6);
  CHECK(held.stats.evaluations > 0);
}

TEST_CASE("accuracy: a slow body takes one step, and a fast one that slows down fewer and fewer") {
  World world;
  const BodyId wheel = add_wheel(world);
  set_accuracy(world, 1e-6);
  step(world);
  CHECK(most_sub_steps(world).count >= 8);
  set_spin(world, wheel, vec(0, 0, 0.1));
  advance(world, 3.0);
  CHECK(most_sub_steps(world).count == 1);
}

TEST_CASE("accuracy: kicks of laws are divided where the forces change fast") {
  World world;
  cases::add_kepler_pair(world, 0.1, 4.4);
  world.settings.step = 1.0 / 60;
  set_accuracy(world, 1e-3);
  std::uint32_t near = 0, far = 1000;
  while (world.time < 6.0) {
    step(world);
    near = std::max(near, most_sub_steps(world).count);
    far = std::min(far, most_sub_steps(world).count);
  }
  CHECK(near >= 16);
  CHECK(far < near);
  CHECK(world.worst.energy <= 1e-3);
}

TEST_CASE("accuracy: the same bits for any number of threads") {
  const auto hash = [](int threads) {
    World world;
    world.workers = std::make_unique<Workers>(threads);
    for (int i = 0; i < 20; i++) cases::add_chain(world, {.links = 2 + i, .start = vec(0, 0, i)});
    add_wheel(world);
    world.settings.gravity = vec(0, -9.81, 0);
    set_accuracy(world, 1e-3);
    advance(world, 0.2);
    return state_hash(world);
  };
  CHECK(hash(2) == hash(1));
}

TEST_CASE("accuracy: must be more than 0, and of an integrator that it can divide") {
  World world;
  CHECK_THROWS_WITH(set_accuracy(world, 0.0), Contains("accuracy must be > 0"));
  CHECK_THROWS_WITH(set_accuracy(world, -1.0), Contains("accuracy must be > 0"));
  set_integrator(world, Integrator::suzuki4);
  CHECK_THROWS_WITH(set_accuracy(world, 1e-3), Contains("fixed steps"));
  CHECK_FALSE(world.settings.accuracy);
}
