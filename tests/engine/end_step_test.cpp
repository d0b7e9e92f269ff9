// A state that overflows stops the world, names what went wrong, and keeps the last state that was good.
#include <catch2/catch.hpp>

#include "measure/measure.hpp"
#include "step/step.hpp"
#include "support/cases.hpp"
#include "support/watch.hpp"

using namespace pantin;

namespace {

/// Steps until the world fails, at most `steps` times; whether it did.
bool fails_within(World& world, int steps) {
  for (int i = 0; i < steps && world.failure.empty(); i++) step(world);
  return !world.failure.empty();
}

void stays_as_it_is(World& world) {
  CHECK(all_finite(world));
  const std::uint64_t hash = state_hash(world), steps = world.steps;
  const double time = world.time;
  const std::string failure = world.failure;
  for (int i = 0; i < 3; i++) step(world);
  CHECK(state_hash(world) == hash);
  CHECK(world.steps == steps);
  CHECK(world.time == time);
  CHECK(world.failure == failure);
}

}  // namespace

TEST_CASE("bad state: a particle that flies out of all numbers stops the world") {
  World world;
  ParticleDef def;
  def.velocity = vec(1e308, 0, 0);
  def.name = "comet";
  add_particle(world, def);
  REQUIRE(fails_within(world, 2000));
  CHECK_THAT(world.failure, Catch::Contains("comet"));
  stays_as_it_is(world);
}

TEST_CASE("bad state: gravity that nothing can stand stops the world") {
  World world;
  world.settings.gravity = vec(0, -1e308, 0);
  BodyDef def;
  def.name = "stone";
  cases::add_rod_body(world, 1, 1, def);
  REQUIRE(fails_within(world, 2000));
  CHECK_THAT(world.failure, Catch::Contains("stone"));
  stays_as_it_is(world);
}

TEST_CASE("bad state: a chain kicked beyond all numbers stops the world and names a link") {
  World world;
  const cases::Chain chain = cases::add_chain(world, {.links = 3});
  advance(world, 0.1);
  kick(world, chain.bodies[1], vec(1e308, 1e308, 0));
  REQUIRE(fails_within(world, 2000));
  CHECK_THAT(world.failure, Catch::Contains("link"));
  stays_as_it_is(world);
}

TEST_CASE("bad state: what goes well beside what does not is where it was at the last good state, too") {
  World world;
  const cases::Chain bad = cases::add_chain(world, {.links = 3}),
                     good = cases::add_chain(world, {.links = 4, .start = vec(0, 0, 1)});
  advance(world, 0.1);
  const Motion before = world.motion_of(good.bodies[3]);
  kick(world, bad.bodies[1], vec(1e308, 1e308, 0));
  step(world);
  REQUIRE(world.failure != "");
  const Motion& now = world.motion_of(good.bodies[3]);
  CHECK(same(now.x, before.x));
  CHECK(same(now.p, before.p));
  CHECK(same(now.angular, before.angular));
  CHECK(now.q.w == before.q.w);
}

TEST_CASE("bad state: gravity beyond all numbers stops a falling ring and names a side") {
  World world;
  world.settings.gravity = vec(0, -1e308, 0);
  remove(world, cases::add_ring(world, 6).pin);
  REQUIRE(fails_within(world, 2000));
  CHECK_THAT(world.failure, Catch::Contains("side"));
  stays_as_it_is(world);
}

TEST_CASE("bad state: a hinge between points apart is an error, and joins nothing") {
  World world;
  const cases::Chain chain = cases::add_chain(world, {.links = 2});
  BodyDef def;
  def.at = vec(2.5, 0.001, 0);
  const BodyId rod = cases::add_rod_body(world, 1, 1, def);
  const std::vector<PointId> apart = {chain.tails.back(), cases::point_of(world, rod, 0)};
  CHECK_THROWS_WITH(add_hinge(world, apart),
                    Catch::Contains("apart") && Catch::Contains("0.001 m") && Catch::Contains("tolerance"));
  CHECK(world.points[apart[0]].particle == world.points[apart[0]].own);
  CHECK(world.points[apart[1]].particle == world.points[apart[1]].own);
}

TEST_CASE("bad state: points within the tolerance are joined, and the gap is closed or stays as it is") {
  World world;
  const cases::Chain chain = cases::add_chain(world, {.links = 2});
  BodyDef def;
  def.at = vec(2.5, 1e-7, 0);
  const BodyId rod = cases::add_rod_body(world, 1, 1, def);
  const PointId head = cases::point_of(world, rod, 0);
  add_hinge(world, std::vector{chain.tails.back(), head});
  step(world);
  CHECK(world.failure == "");
  CHECK(norm(position(world, chain.tails.back()) - position(world, head)) <= 1e-10);
  const Watched course = watch(world, 2.0);
  CHECK(course.gap <= 1e-10);
}

TEST_CASE("bad state: a loop built too long by less than the tolerance runs on") {
  World world;
  const double excess = 1e-7;
  const BodyId beam = cases::add_rod_body(world, 1, 2);
  BodyDef left, right;
  left.at = vec(-0.5, 0, 0);
  right.at = vec(0.5 + excess, 0, 0);
  const BodyId first = cases::add_rod_body(world, 1, 1, left), second = cases::add_rod_body(world, 1, 1, right);
  add_hinge(world, std::vector{cases::point_of(world, beam, 0), cases::point_of(world, first, 0)});
  add_hinge(world, std::vector{cases::point_of(world, first, 1), cases::point_of(world, second, 0)});
  add_hinge(world, std::vector{cases::point_of(world, beam, 1), cases::point_of(world, second, 1)});
  const Watched course = watch(world, 2.0);
  CHECK(course.failure == "");
  CHECK(course.finite);
  CHECK(course.gap <= 2 * excess);
}
