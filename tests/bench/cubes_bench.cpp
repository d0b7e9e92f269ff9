// `pantin bench cubes`: cubes of particles and solved springs, in the air and as they land.
#include <algorithm>
#include <cstdio>
#include <limits>

#include "base/check.hpp"
#include "bench/clock.hpp"
#include "edit/edit.hpp"
#include "measure/measure.hpp"
#include "player/bench.hpp"
#include "step/step.hpp"
#include "support/cases.hpp"

using namespace pantin;

namespace {

constexpr double apart = 0.15, mass = 0.05, radius = 0.06;  // [m], [kg], [m]

/// [s] Of a step of a cube whose first particle was struck, the fastest of some.
double step_in_the_air(int edge) {
  constexpr int warm = 3, timed = 10;
  World world;
  const auto cube = cases::add_cube(world, {.edge = edge, .apart = apart, .mass = mass, .stiffness = 2e4});
  set_velocity(world, cases::point_of(world, cube.front()), vec(1, 0.5, 0));
  for (int i = 0; i < warm; i++) step(world);
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < timed; i++) {
    const double start = now();
    step(world);
    best = std::min(best, now() - start);
  }
  require(world.failure.empty(), "bench cubes: ", world.failure);
  return best;
}

/// Drops one by 0.7 m onto a box that is smaller than it, and looks at it for a second.
void land(double stiffness, int rate) {
  World world;
  world.settings.step = 1.0 / rate;
  ShapeDef box;
  box.geometry = BoxShape{vec(0.2, 0.2, 0.2)};
  box.at = vec(0.3, 0.2, 0.3);
  add_shape(world, box);
  FamilyDef jelly;
  jelly.name = "jelly";
  jelly.radius = radius;
  jelly.solid.emplace();
  jelly.layer = "jelly";
  const FamilyId family = add_family(world, jelly);
  LayerRule rule;
  rule.collide = false;
  set_rule(world, "jelly", "jelly", rule);
  cases::add_cube(
      world,
      {.apart = apart, .mass = mass, .stiffness = stiffness, .family = family, .start = vec(0, 0.4 + radius + 0.7, 0)});
  const auto whole = [&] { return energy(world).kinetic + energy(world).potential; };
  const double before = whole();
  while (world.time < 0.56 && world.failure.empty()) step(world);
  const double taken = (before - whole()) / (125 * mass * 9.81 * 0.7);
  while (world.time < 1.0 && world.failure.empty()) step(world);
  std::printf("%12.0e %8d %14.1e %14.1f %14.1f\n", stiffness, rate, world.worst.energy,
              100.0 * world.worst.penetration / (2.0 * radius), 100.0 * taken);
  std::fflush(stdout);
}

void bench_cubes(const player::BenchOptions&) {
  std::printf("a step of 1/240 s, springs of 2e4 N/m to all 26 about each particle of 0.05 kg, one thread\n%8s %8s\n",
              "edge", "ms");
  for (const int edge : {3, 4, 5, 6, 8}) {
    std::printf("%8d %8.2f\n", edge, 1e3 * step_in_the_air(edge));
    std::fflush(stdout);
  }
  std::printf("a cube of 125 that lands on a box: 1 s\n%12s %8s %14s %14s %14s\n", "N/m", "Hz", "energy error",
              "overlap, %", "taken, %");
  for (const double stiffness : {2e3, 2e4})
    for (const int rate : {60, 240, 960}) land(stiffness, rate);
}

const player::Register cubes_benchmark({"cubes", "particles with springs that are solved, and as they land",
                                        bench_cubes});

}  // namespace
