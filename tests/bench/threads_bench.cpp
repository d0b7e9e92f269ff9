// `pantin bench threads`: chains, stacks and one heap at 1/240 s, by one thread and by more.
#include <algorithm>
#include <cstdio>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "base/check.hpp"
#include "base/parallel.hpp"
#include "bench/clock.hpp"
#include "forces/sleep.hpp"
#include "measure/measure.hpp"
#include "peers/piles.hpp"
#include "player/bench.hpp"
#include "step/step.hpp"
#include "support/cases.hpp"
#include "support/mechanisms.hpp"

using namespace pantin;

namespace {

constexpr int window = 10, windows = 8;

struct Case {
  std::string name;
  int warm;  ///< steps before it is measured
  std::function<void(World&)> make;
};

struct Turn {
  int threads = 1;
  double best = std::numeric_limits<double>::infinity();  ///< [s] of a window
  World world;
};

void add_chains(World& world) {
  for (int i = 0; i < 1000; i++) cases::add_chain(world, {.links = 20, .start = vec(0, 0, i)});
}

void add_pile(World& world, peers::Mechanism pile) {
  world.settings.gravity = vec(0, -peers::gravity, 0);
  support::add_mechanism(world, pile);
}

void add_stacks(World& world) {
  const peers::Mechanism one = peers::pile("stack(10)");
  peers::Mechanism all = one;
  for (int i = 1; i < 100; i++)
    for (peers::SolidDef solid : one.solids) {
      solid.at.x() += 3.0 * i;
      all.solids.push_back(solid);
    }
  add_pile(world, all);
}

void advance(Turn& turn, int steps) {
  for (int i = 0; i < steps; i++) {
    wake_all(turn.world);
    step(turn.world);
  }
}

void measure(const Case& c) {
  Turn turns[3];
  for (int k = 0; k < 3; k++) {
    turns[k].threads = 1 << k;
    turns[k].world.workers = std::make_unique<Workers>(turns[k].threads);
    turns[k].world.settings.step = 1.0 / 240.0;
    c.make(turns[k].world);
    advance(turns[k], c.warm);
  }
  for (int i = 0; i < windows; i++)  // by turns, so that what else the machine does meets all alike
    for (Turn& turn : turns) {
      const double start = now(2);
      advance(turn, window);
      turn.best = std::min(turn.best, now(2) - start);
    }
  std::printf("\n%s\n%8s %12s %8s %18s\n", c.name.c_str(), "threads", "ms/step", "ratio", "hash");
  for (const Turn& turn : turns) {
    std::printf("%8d %12.2f %8.2f %18llx\n", turn.threads, 1e3 * turn.best / window, turns[0].best / turn.best,
                static_cast<unsigned long long>(state_hash(turn.world)));
    require(state_hash(turn.world) == state_hash(turns[0].world), "the bits depend on the number of threads");
  }
}

void bench_threads(const player::BenchOptions&) {
  std::printf("1/240 s, nothing sleeps, time of the clock: the best of %d times %d steps\n", windows, window);
  measure({"1000 chains of 20 links", 30, add_chains});
  measure({"100 stacks of 10 boxes", 30, add_stacks});
  for (const int warm : {240, 720})
    measure({text("a heap of 1000 boxes, after ", warm / 240, " s"), warm,
             [](World& world) { add_pile(world, peers::pile("boxes(1000)")); }});
}

const player::Register threads_benchmark({"threads",
                                          "1000 chains, 100 stacks and a heap of 1000 boxes by 1, 2 and 4 threads",
                                          bench_threads});

}  // namespace
