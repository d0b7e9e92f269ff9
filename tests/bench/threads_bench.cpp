// `pantin bench threads`: a thousand chains of twenty links at 1/240 s, by one thread and by more.
#include <algorithm>
#include <cstdio>
#include <limits>
#include <vector>

#include "base/check.hpp"
#include "base/parallel.hpp"
#include "bench/clock.hpp"
#include "measure/measure.hpp"
#include "player/bench.hpp"
#include "step/step.hpp"
#include "support/cases.hpp"

namespace pantin {

namespace {

constexpr int chains = 1000, links = 20, warm = 30, window = 10, windows = 8;

struct Turn {
  int threads = 1;
  double best = std::numeric_limits<double>::infinity();  ///< [s] of a window
  World world;
};

void make(Turn& turn) {
  turn.world.workers = std::make_unique<Workers>(turn.threads);
  for (int i = 0; i < chains; i++) cases::add_chain(turn.world, {.links = links, .start = vec(0, 0, i)});
  for (int i = 0; i < warm; i++) step(turn.world);
}

void bench_threads(const player::BenchOptions&) {
  Turn turns[3];
  for (int k = 0; k < 3; k++) {
    turns[k].threads = 1 << k;
    make(turns[k]);
  }
  for (int i = 0; i < windows; i++)  // by turns, so that what else the machine does meets all alike
    for (Turn& turn : turns) {
      const double start = now(2);
      for (int k = 0; k < window; k++) step(turn.world);
      turn.best = std::min(turn.best, now(2) - start);
    }
  std::printf("%d chains of %d links at 1/240 s, time of the clock\n", chains, links);
  std::printf("%8s %12s %14s %8s %18s\n", "threads", "ms/step", "ns/link/step", "ratio", "hash");
  for (const Turn& turn : turns) {
    const double each = turn.best / window;
    std::printf("%8d %12.2f %14.1f %8.2f %18llx\n", turn.threads, 1e3 * each, 1e9 * each / (chains * links),
                turns[0].best / turn.best, static_cast<unsigned long long>(state_hash(turn.world)));
    require(state_hash(turn.world) == state_hash(turns[0].world), "the bits depend on the number of threads");
  }
}

const player::Register threads_benchmark({"threads", "1000 chains of 20 links by 1, 2 and 4 threads", bench_threads});

}  // namespace

}  // namespace pantin
