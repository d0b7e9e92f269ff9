// `pantin bench snapshot`: what it costs to keep the state of a world and to go back to it, as games do that predict inputs.
#include <malloc.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include "bench/clock.hpp"
#include "edit/edit.hpp"
#include "player/bench.hpp"
#include "snapshot/snapshot.hpp"
#include "snapshot/world_state.hpp"
#include "step/step.hpp"
#include "support/cases.hpp"

using namespace pantin;

namespace {

constexpr int warm_steps = 120, rounds = 201;
constexpr std::size_t ring_size = 8;

void add_boxes(World& world, double apart, double above) {
  ShapeDef floor;
  floor.geometry = HalfSpaceShape{};
  floor.orientation = {std::sqrt(0.5), -std::sqrt(0.5), 0, 0};
  add_shape(world, floor);
  ShapeDef box;
  box.geometry = BoxShape{vec(0.5, 0.5, 0.5)};
  for (int i = 0; i < 1000; i++) {
    BodyDef body;
    body.shapes = {box};
    body.at = vec(i % 10 * 1.1, above + 0.5 + i / 100 * apart, i / 10 % 10 * 1.1);
    add_body(world, body);
  }
}

double middle_of(std::vector<double> list) {
  std::nth_element(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(list.size() / 2), list.end());
  return list[list.size() / 2];
}

template <class Do>
double timed_median(Do act) {
  std::vector<double> times;
  for (int i = 0; i < rounds; i++) {
    const double start = now();
    act(static_cast<std::size_t>(i));
    times.push_back(now() - start);
  }
  return middle_of(times);
}

/// The bytes of a state, as a file has them.
std::size_t bytes_of(World& world) {
  Writer to;
  visit_world(to, world);
  return to.bytes.size();
}

/// The memory that a snapshot takes [bytes].
std::size_t memory_of(const World& world) {
  const std::size_t before = mallinfo2().uordblks;
  const Snapshot snapshot = take_snapshot(world);
  return mallinfo2().uordblks - before;
}

void measure_world(const char* name, World& world) {
  for (int i = 0; i < warm_steps; i++) step(world);
  std::vector<Snapshot> ring(ring_size);
  for (Snapshot& snapshot : ring) {
    take_snapshot(world, snapshot);
    step(world);
  }
  const double taken = timed_median([&](std::size_t i) { take_snapshot(world, ring[i % ring_size]); });
  const double restored = timed_median([&](std::size_t i) { restore(world, ring[i % ring_size]); });
  const std::size_t bytes = bytes_of(world), memory = memory_of(world);
  std::vector<std::vector<char>> copies(ring_size, std::vector<char>(bytes)), from = copies;
  const double copied = timed_median([&](std::size_t i) {
    std::memcpy(copies[i % ring_size].data(), from[(i + 1) % ring_size].data(), bytes);
    std::memcpy(from[i % ring_size].data(), copies[(i + 1) % ring_size].data(), bytes);
  });
  const double stepped = timed_median([&](std::size_t) { step(world); });
  std::printf("%-24s %9.3f %9.3f %9.3f %9.3f %12.1f %12.1f %9.3f\n", name, 1e3 * taken, 1e3 * restored,
              1e3 * (taken + restored), 1e3 * copied, static_cast<double>(bytes) / 1024.0,
              static_cast<double>(memory) / 1024.0, 1e3 * stepped);
  std::fflush(stdout);
}

void bench_snapshot(const player::BenchOptions&) {
  std::printf("a ring of %zu states, a step apart, one thread's processor time, medians of %d [ms]\n", ring_size,
              rounds);
  std::printf("%-24s %9s %9s %9s %9s %12s %12s %9s\n", "", "take", "restore", "both", "memcpy", "file [KiB]",
              "memory [KiB]", "a step");
  {
    World world;
    add_boxes(world, 3.0, 50.0);
    measure_world("1000 boxes in the air", world);
  }
  {
    World world;
    add_boxes(world, 1.0, 0.0);
    measure_world("1000 boxes in towers", world);
  }
  {
    World world;
    cases::ChainDef chain;
    chain.links = 1000;
    cases::add_chain(world, chain);
    measure_world("1 chain of 1000", world);
  }
}

const player::Register snapshot_benchmark({"snapshot", "what it costs to keep a state and to go back to it",
                                           bench_snapshot});

}  // namespace
