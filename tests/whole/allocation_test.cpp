// A step asks for no memory once it is warm.
#include <catch2/catch.hpp>

#include <new>

#include "choreography/hands.hpp"
#include "step/step.hpp"
#include "support/allocations.hpp"
#include "support/cases.hpp"

using namespace pantin;

namespace {

std::uint64_t allocations_in(World& world, int steps) {
  const std::uint64_t before = allocations();
  for (int i = 0; i < steps; i++) step(world);
  return allocations() - before;
}

}  // namespace

TEST_CASE("allocation: the count sees what is allocated") {
  const std::uint64_t before = allocations();
  ::operator delete(::operator new(16));
  CHECK(allocations() == before + 1);
}

TEST_CASE("allocation: a warm step of a chain among free particles allocates nothing") {
  World world;
  cases::add_chain(world, {.links = 50});
  for (int i = 0; i < 20; i++) {
    ParticleDef def;
    def.at = vec(i, 3, 0);
    add_particle(world, def);
  }
  for (int i = 0; i < 50; i++) step(world);
  CHECK(allocations_in(world, 100) == 0);
}

TEST_CASE("allocation: a warm step of a ring, a heavy chain, rods and a hand allocates nothing") {
  World world;
  cases::add_ring(world, 24);
  cases::add_double_pendulum(world);
  const cases::Chain heavy = cases::add_heavy_chain(world, 10, 1e6);
  const std::int32_t hand = add_hand(world, [](double time) { return vec(10, time, 5); });
  grab(world, hand, heavy.tails.back(), 200.0);
  for (int i = 0; i < 50; i++) step(world);
  CHECK(allocations_in(world, 100) == 0);
}

TEST_CASE("allocation: not even the fallback step allocates when it is warm") {
  World world;
  const cases::Chain chain = cases::add_chain(world);
  FollowDef follow;
  follow.target = [](double time) { return vec(10 + 5 * time, 0, 0); };
  add_follow(world, chain.tails.back(), follow);
  for (int i = 0; i < 50; i++) step(world);
  REQUIRE(world.stats.fallback_steps > 0);
  CHECK(allocations_in(world, 100) == 0);
}

TEST_CASE("allocation: a target that is a function of time costs no memory") {
  World world;
  const cases::Chain chain = cases::add_chain(world);
  FollowDef follow;
  follow.target = [](double time) { return vec(10 - time, 0, 0); };
  add_follow(world, chain.tails.back(), follow);
  for (int i = 0; i < 50; i++) step(world);
  CHECK(allocations_in(world, 100) == 0);
}

TEST_CASE("allocation: a warm step of trees of hinges allocates nothing") {
  World world;
  world.settings.integrator = Integrator::adaptive;
  cases::add_chain(world, {.links = 20});
  cases::add_wheel(world);
  for (int i = 0; i < 100; i++) step(world);
  REQUIRE(world.stats.evaluations > 0);
  CHECK(allocations_in(world, 100) == 0);
}
