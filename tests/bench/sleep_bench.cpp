// `pantin bench sleep`: a thousand chains at rest, asleep and kept awake, with a law that damps them and without; and a
// thousand boxes that lie apart.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>

#include "base/check.hpp"
#include "edit/edit.hpp"
#include "forces/sleep.hpp"
#include "laws/library.hpp"
#include "player/bench.hpp"
#include "player/machine.hpp"
#include "step/step.hpp"
#include "support/cases.hpp"

using namespace pantin;

namespace {

constexpr int chains = 1000, links = 5;

void add_hanging_chains(World& world) {
  for (int i = 0; i < chains; i++) {
    const cases::Chain chain = cases::add_chain(world, {.links = links, .start = vec(0, 0, 2.0 * i)});
    for (int k = 0; k < links; k++) {
      const double half = std::sqrt(0.5);
      set_orientation(world, chain.bodies[static_cast<std::size_t>(k)], {half, 0, 0, -half});
      set_position(world, chain.bodies[static_cast<std::size_t>(k)], vec(0, -0.5 - k, 2.0 * i));
    }
  }
}

/// Least time of some steps [ns], `before` each of them.
template <class Before>
double time_of_step(World& world, Before before) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 60; i++) {
    before();
    const double start = player::thread_time();
    step(world);
    least = std::min(least, player::thread_time() - start);
  }
  require(world.failure.empty(), world.failure);
  return least;
}

void measure_sleep(bool damped) {
  World world;
  add_hanging_chains(world);
  LawArguments arguments;
  arguments.numbers = {{"linear", 2.0}};
  if (damped) add_field(world, std::make_shared<const Law>(make_library_law("drag", arguments).front()), {});
  for (int i = 0; i < 4000 && sleepers(world) < chains; i++) step(world);
  require(sleepers(world) == chains, "only ", sleepers(world), " chains fell asleep");
  const double asleep = time_of_step(world, [] {});
  // One that moves has the forces of all be found; nothing else is done for the others.
  const double one = time_of_step(world, [&] { wake(world, world.bodies.ids()[0]); });
  const double awake = time_of_step(world, [&] { wake_all(world); });
  std::printf("%8s %14.2f %14.2f %14.3f %10.0f %10.0f\n", damped ? "drag" : "none", awake / 1e3, one / 1e3,
              asleep / 1e3, awake / one, awake / asleep);
}

void measure_sleep_in_touch() {
  constexpr std::size_t boxes = 1000;
  World world, empty;
  ShapeDef ground;
  ground.geometry = HalfSpaceShape{};
  ground.orientation = {std::sqrt(0.5), -std::sqrt(0.5), 0, 0};
  BodyDef box;
  box.shapes.resize(1);
  box.shapes[0].geometry = BoxShape{vec(0.5, 0.5, 0.5)};
  for (World* w : {&world, &empty}) add_shape(*w, ground);
  for (std::size_t i = 0; i < boxes; i++) {
    box.at = vec(2.0 * static_cast<double>(i), 0.5, 0);
    add_body(world, box);
  }
  for (int i = 0; i < 4000 && !all_asleep(world); i++) step(world);
  require(all_asleep(world), "only ", sleepers(world), " boxes fell asleep");
  const double none = time_of_step(empty, [] {}), asleep = time_of_step(world, [] {});
  box.at = vec(-10, 1000, 0);
  add_body(world, box);
  add_body(empty, box);
  const double falling = time_of_step(world, [] {}), alone = time_of_step(empty, [] {});
  std::printf("\n%zu boxes asleep, apart on the ground: %.2f ns a box and step; with one more that falls: %.2f ns\n",
              boxes, (asleep - none) / boxes, (falling - alone) / boxes);
}

void bench_sleep(const player::BenchOptions&) {
  std::printf("%d chains of %d links that hang at rest, 1/240 s, one thread's processor time of a step, us\n", chains,
              links);
  std::printf("%8s %14s %14s %14s %10s %10s\n", "law", "all awake", "one awake", "all asleep", "ratio", "ratio");
  measure_sleep(false);
  measure_sleep(true);
  measure_sleep_in_touch();
}

const player::Register sleep_benchmark({"sleep", "1000 chains at rest, asleep and awake", bench_sleep});

}  // namespace
