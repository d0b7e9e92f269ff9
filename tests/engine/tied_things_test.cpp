// Cutting, joining and changing while the world runs: nothing fails, and momentum is kept.
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "measure/measure.hpp"
#include "step/step.hpp"
#include "support/cases.hpp"
#include "support/watch.hpp"

using namespace pantin;

TEST_CASE("running edits: a chain cut hinge by hinge keeps momentum and angular momentum") {
  World world;
  world.settings.gravity = zero3();
  const cases::Chain chain = cases::add_chain(world, {.links = 20, .pinned = false});
  kick(world, chain.bodies[3], vec(3, 5, -2), vec(3.2, 0.1, 0));
  kick(world, chain.bodies[15], vec(-1, -4, 6), vec(15.9, 0, 0.1));
  const Things all = everything(world);
  const Vec3 p = momentum(world, all), l = angular_momentum(world, all);
  for (std::size_t i = 0; i < chain.hinges.size(); i++) {
    const Watched course = watch(world, world.time + 10 * world.settings.step);
    REQUIRE(course.failure == "");
    CHECK(course.gap <= 1e-10);
    cut(world, chain.hinges[i * 7 % chain.hinges.size()]);
  }
  watch(world, world.time + 0.5);
  CHECK(norm(momentum(world, all) - p) <= 1e-12 * norm(p));
  CHECK(norm(angular_momentum(world, all) - l) <= 1e-12 * norm(l));
  CHECK(world.articulates.empty());
  CHECK(world.stats.fallback_steps == 0);
}

TEST_CASE("running edits: a pinned chain in gravity falls apart link by link") {
  World world;
  const cases::Chain chain = cases::add_chain(world, {.links = 30});
  for (const ParticleId hinge : chain.hinges) {
    const Watched course = watch(world, world.time + 5 * world.settings.step);
    REQUIRE(course.failure == "");
    CHECK(course.gap <= 1e-10);
    cut(world, hinge);
  }
  remove(world, chain.pin);
  const Watched course = watch(world, world.time + 1.0);
  CHECK(course.failure == "");
  CHECK(course.finite);
  CHECK(course.energy_error() <= 1e-9);
}

TEST_CASE("running edits: two flying bodies joined at a common point keep momentum and angular momentum") {
  World world;
  world.settings.gravity = zero3();
  BodyDef left, right;
  left.at = vec(-0.5, 0, 0);
  left.velocity = vec(2, 0, 1);
  left.spin = vec(0, 3, 0);
  right.at = vec(0.5, 0, 0);
  right.velocity = vec(-1, 1, 0);
  right.spin = vec(1, 0, -2);
  const BodyId a = cases::add_rod_body(world, 1, 1, left), b = cases::add_rod_body(world, 3, 1, right);
  const Things all = everything(world);
  const Vec3 p = momentum(world, all), l = angular_momentum(world, all);
  const PointId tail = cases::point_of(world, a, 1), head = cases::point_of(world, b, 0);
  add_hinge(world, std::vector{tail, head});
  const Watched course = watch(world, 2.0);
  CHECK(course.failure == "");
  CHECK(course.gap <= 1e-10);
  CHECK(norm(velocity(world, tail) - velocity(world, head)) <= 1e-6);
  CHECK(norm(momentum(world, all) - p) <= 1e-12 * norm(p));
  CHECK(norm(angular_momentum(world, all) - l) <= 1e-12 * norm(l));
}

// The impulse J at the joint stops the difference of the two velocities there, which J changes by 1/m + l²/I on each side.
TEST_CASE("running edits: the energy that joining two moving rods takes stays gone") {
  World world;
  world.settings.gravity = zero3();
  BodyDef left, right;
  left.at = vec(-0.5, 0, 0);
  left.velocity = vec(0, 1, 0);
  right.at = vec(0.5, 0, 0);
  const BodyId a = cases::add_rod_body(world, 1, 1, left), b = cases::add_rod_body(world, 1, 1, right);
  add_hinge(world, std::vector{cases::point_of(world, a, 1), cases::point_of(world, b, 0)});
  const double inertia = 1.01 / 12, impulse = 0.5 / (1 + 0.25 / inertia);
  const double turning = 2 * 0.5 * (0.5 * impulse) * (0.5 * impulse) / inertia;
  const double expected = 0.5 * (1 - impulse) * (1 - impulse) + 0.5 * impulse * impulse + turning;
  step(world);
  CHECK(energy(world).kinetic == Approx(expected).epsilon(1e-4));
  const double after = energy(world).kinetic;
  watch(world, 2.0);
  CHECK(energy(world).kinetic == Approx(after).epsilon(1e-9));
}

TEST_CASE("running edits: hinges cut and made again every ten steps never fail") {
  World world;
  cases::Chain chain = cases::add_chain(world, {.links = 31});
  std::uint32_t random = 12345;
  for (int i = 0; i < 60; i++) {
    const Watched course = watch(world, world.time + 10 * world.settings.step);
    REQUIRE(course.failure == "");
    CHECK(course.gap <= 1e-9);
    random = random * 1664525u + 1013904223u;
    const std::size_t k = (random >> 8) % chain.hinges.size();
    const std::vector<PointId> members = world.particles[chain.hinges[k]].points;
    cut(world, chain.hinges[k]);
    chain.hinges[k] = add_hinge(world, members);
  }
  CHECK(world.stats.fallback_steps == 0);
}

TEST_CASE("running edits: a mass changed in flight keeps the velocities of all points") {
  World world;
  const cases::Chain chain = cases::add_chain(world);
  advance(world, 0.5);
  const Vec3 head = velocity(world, chain.heads[4]), tail = velocity(world, chain.tails[4]);
  set_own_mass(world, chain.bodies[4], 50.0);
  CHECK(norm(velocity(world, chain.heads[4]) - head) <= 1e-12 * norm(head));
  CHECK(norm(velocity(world, chain.tails[4]) - tail) <= 1e-12 * norm(tail));
  const Watched course = watch(world, 3.0);
  CHECK(course.failure == "");
  CHECK(course.gap <= 1e-10);
  CHECK(course.energy_error() <= 1e-9);
}

TEST_CASE("running edits: a kick leaves the graph as it is, and moves the chain as one found anew") {
  World kept, anew;
  const cases::Chain chain = cases::add_chain(kept);
  cases::add_chain(anew);
  for (World* world : {&kept, &anew}) {
    advance(*world, 0.5);
    kick(*world, chain.bodies[4], vec(1, 2, 3));
    set_spin(*world, chain.bodies[6], vec(0, 0, 2));
  }
  mark_edited(anew, chain.bodies[4]);
  const Articulate* before = kept.articulates.front().get();
  for (World* world : {&kept, &anew}) advance(*world, 1.0);
  CHECK(kept.articulates.front().get() == before);
  CHECK(kept.stats.fallback_steps == 0);
  for (const BodyId body : chain.bodies) CHECK(norm(kept.motion_of(body).x - anew.motion_of(body).x) < 1e-9);
}

TEST_CASE("running edits: a link taken out of the middle leaves two chains") {
  World world;
  const cases::Chain chain = cases::add_chain(world);
  advance(world, 0.5);
  remove(world, chain.bodies[5]);
  const Watched course = watch(world, 2.0);
  CHECK(course.failure == "");
  CHECK(course.gap <= 1e-10);
  CHECK(course.energy_error() <= 1e-9);
  CHECK(world.articulates.size() == 2);
  CHECK_FALSE(world.particles.alive(chain.hinges[4]));
}
