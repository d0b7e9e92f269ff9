// `pantin bench hubs`: time per hinge and step of a disc with growing numbers of spokes, beside a chain of as many hinges.
#include <algorithm>
#include <cstdio>
#include <limits>

#include "base/check.hpp"
#include "bench/clock.hpp"
#include "player/bench.hpp"
#include "step/step.hpp"
#include "support/cases.hpp"

using namespace pantin;

namespace {

constexpr int warm = 30, windows = 8, window = 5;

/// [s] of a step, the fastest window of some.
double step_time(World& world) {
  for (int i = 0; i < warm; i++) step(world);
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < windows; i++) {
    const double start = now();
    for (int k = 0; k < window; k++) step(world);
    best = std::min(best, (now() - start) / window);
  }
  require(world.failure.empty(), "bench hubs: ", world.failure);
  return best;
}

void bench_hubs(const player::BenchOptions&) {
  std::printf("a disc with spokes of two links, kicked; 1/240 s, one thread's processor time\n");
  std::printf("%8s %8s %14s %14s %8s %12s %12s\n", "spokes", "hinges", "ns/hinge/step", "of a chain", "ratio",
              "iterations", "gap, m");
  for (const int spokes : {4, 8, 9, 50, 150, 500}) {
    World disc, chain;
    const cases::Wheel wheel = cases::add_wheel(disc, {.spokes = spokes});
    kick(disc, wheel.hub, vec(30, 0, 20), vec(1, 0, 0));
    cases::add_chain(chain, {.links = 2 * spokes});
    const double each = step_time(disc) / (2 * spokes), of_chain = step_time(chain) / (2 * spokes);
    std::printf("%8d %8d %14.1f %14.1f %8.2f %12.2f %12.1e\n", spokes, 2 * spokes, 1e9 * each, 1e9 * of_chain,
                each / of_chain, static_cast<double>(disc.stats.newton_iterations) / static_cast<double>(disc.steps),
                disc.worst.hinge_gap);
    std::fflush(stdout);
  }
}

const player::Register hubs_benchmark({"hubs", "a body of up to 500 hinges", bench_hubs});

}  // namespace
