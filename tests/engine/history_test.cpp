// What an edit leaves of an articulate: all of it where nothing changed, else what the last steps taught of the rest.
#include <catch2/catch.hpp>
#include <vector>

#include "articulates/articulate.hpp"
#include "measure/measure.hpp"
#include "step/step.hpp"
#include "support/cases.hpp"
#include "support/watch.hpp"

using namespace pantin;

namespace {

void rejoin(World& world, ParticleId& hinge) {
  const std::vector<PointId> members = world.particles[hinge].points;
  cut(world, hinge);
  hinge = add_hinge(world, members);
}

void steps(World& world, int count) {
  for (int i = 0; i < count; i++) step(world);
}

std::uint64_t iterations_of_next_step(World& world) {
  const std::uint64_t before = world.stats.newton_iterations;
  step(world);
  return world.stats.newton_iterations - before;
}

}  // namespace

TEST_CASE("history: a hinge cut and made again between two steps changes no bit of the motion") {
  World still, edited;
  cases::add_chain(still, {.links = 31});
  cases::Chain chain = cases::add_chain(edited, {.links = 31});
  for (std::size_t i = 0; i < 30; i++) {
    steps(still, 3);
    steps(edited, 3);
    const Articulate* before = edited.articulates[0].get();
    rejoin(edited, chain.hinges[i]);
    step(still);
    step(edited);
    CHECK(edited.articulates[0].get() == before);
  }
  for (std::size_t i = 0; i < chain.bodies.size(); i++) {
    const Motion &a = still.motion[i], &b = edited.motion_of(chain.bodies[i]);
    CHECK(same(a.x, b.x));
    CHECK(same(a.p, b.p));
    CHECK(same(a.angular, b.angular));
  }
}

TEST_CASE("history: kicks, velocities and positions set leave the graph as it is") {
  World world;
  const cases::Chain chain = cases::add_chain(world);
  steps(world, 5);
  const Articulate* before = world.articulates[0].get();
  kick(world, chain.bodies[3], vec(0, 0, 1));
  step(world);
  set_velocity(world, chain.bodies[5], vec(0, 1, 0));
  step(world);
  set_spin(world, chain.bodies[5], vec(0, 0, 1));
  step(world);
  set_position(world, chain.bodies[9], position(world, chain.tails[8]) + vec(0.5, 0, 0));
  step(world);
  CHECK(world.articulates[0].get() == before);
  const Watched course = watch(world, world.time + 1.0);
  CHECK(course.failure == "");
  CHECK(course.gap <= 1e-9);
}

TEST_CASE("history: an edit of one articulate leaves the others as they are, in the order of their serials") {
  World world;
  std::vector<cases::Chain> chains;
  for (int i = 0; i < 5; i++) chains.push_back(cases::add_chain(world, {.links = 4, .start = vec(0, 0, i)}));
  steps(world, 5);
  std::vector<const Articulate*> before;
  for (const auto& articulate : world.articulates) before.push_back(articulate.get());
  cut(world, chains[1].hinges[1]);
  step(world);
  REQUIRE(world.articulates.size() == 6);
  CHECK(world.articulates[0].get() == before[0]);
  for (std::size_t i = 2; i < 5; i++) CHECK(world.articulates[i + 1].get() == before[i]);
  for (std::size_t i = 0; i < 6; i++) {
    if (i > 0) CHECK(world.articulates[i - 1]->serial < world.articulates[i]->serial);
    for (std::size_t n = 0; n < world.articulates[i]->nodes.size(); n++) {
      const Motion& motion = world.motion[world.articulates[i]->nodes[n].slot];
      CHECK(motion.articulate == static_cast<std::int32_t>(i));
      CHECK(motion.node == static_cast<std::int32_t>(n));
    }
  }
}

TEST_CASE("history: once a chain has lost its last link, its next step is no harder") {
  World world;
  const cases::Chain chain = cases::add_chain(world, {.links = 100});
  steps(world, 60);
  const std::uint64_t normal = iterations_of_next_step(world);
  cut(world, chain.hinges.back());
  CHECK(iterations_of_next_step(world) <= normal + 2);
}

TEST_CASE("history: a body removed, a mass changed, a nail drawn: the rest moves on with its gaps closed") {
  World world;
  const cases::Chain chain = cases::add_chain(world, {.links = 20});
  steps(world, 20);
  set_own_mass(world, chain.bodies[4], 30.0);
  steps(world, 20);
  remove(world, chain.bodies[10]);
  steps(world, 20);
  remove(world, chain.pin);
  const Watched course = watch(world, world.time + 1.0);
  CHECK(course.failure == "");
  CHECK(course.gap <= 1e-10);
  CHECK(world.articulates.size() == 2);
  CHECK(world.stats.fallback_steps == 0);
}
