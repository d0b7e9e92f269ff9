// `pantin bench choreography`: what waiting events cost a step, and one merge and one cut among many bodies.
#include <algorithm>
#include <cstdio>
#include <limits>

#include "bench/clock.hpp"
#include "player/bench.hpp"
#include "step.hpp"
#include "support/cases.hpp"
#include "world/assemble.hpp"
#include "world/choreography.hpp"

namespace pantin {

namespace {

constexpr int waiting = 100'000, calls = 1000, windows = 10;

/// [s] of one call of fire_events with so many events waiting for later.
double waiting_cost(int events) {
  World world;
  for (int i = 0; i < events; i++) {
    Event event;
    event.time = 1e6 + i;
    event.action = [] {};
    add_event(world, std::move(event));
  }
  double best = std::numeric_limits<double>::infinity();
  for (int w = 0; w < windows; w++) {
    const double start = now(2);
    for (int k = 0; k < calls; k++) fire_events(world, 1e-6 * k);
    best = std::min(best, (now(2) - start) / calls);
  }
  return best;
}

/// [s] of firing one of so many events.
double firing_cost(int events) {
  World world;
  for (int i = 0; i < events; i++) {
    Event event;
    event.time = 1e-3 * (events - i);
    event.action = [] {};
    add_event(world, std::move(event));
  }
  const double start = now(2);
  fire_events(world, 1e-3 * (events + 1));
  return (now(2) - start) / events;
}

struct EditCost {
  double step = 1e9, after_merge = 1e9, after_cut = 1e9;  // [s] with the edit before the step
};

EditCost edit_cost() {
  constexpr int chains = 1000, links = 10;
  World world;
  std::vector<cases::Chain> all;
  for (int i = 0; i < chains; i++) all.push_back(cases::add_chain(world, {.links = links, .start = vec(0, 0, i)}));
  for (int i = 0; i < 20; i++) step(world);
  EditCost cost;
  const auto timed = [&](double& best, auto edit) {
    const double start = now(2);
    edit();
    step(world);
    best = std::min(best, now(2) - start);
  };
  for (std::size_t i = 0; i < 12; i++) {
    timed(cost.step, [] {});
    timed(cost.after_merge, [&] { merge(world, all[i].bodies[4], all[i].bodies[5]); });
    timed(cost.after_cut, [&] { cut(world, all[100 + i].hinges[4]); });
  }
  return cost;
}

void bench_choreography(const player::BenchOptions&) {
  std::printf("%-44s %10.3f us\n", "a step with no events", 1e6 * waiting_cost(0));
  std::printf("%-44s %10.3f us\n", "a step with 100000 events that wait", 1e6 * waiting_cost(waiting));
  std::printf("%-44s %10.3f us\n", "one event of 100000 that fire", 1e6 * firing_cost(waiting));
  const EditCost cost = edit_cost();
  std::printf("%-44s %10.3f ms\n", "a step of 1000 chains of 10 links", 1e3 * cost.step);
  std::printf("%-44s %10.3f ms more\n", "with a merge before it", 1e3 * (cost.after_merge - cost.step));
  std::printf("%-44s %10.3f ms more\n", "with a cut before it", 1e3 * (cost.after_cut - cost.step));
}

const player::Register choreography_benchmark({"choreography",
                                               "events that wait and fire; a merge and a cut among 10,000 bodies",
                                               bench_choreography});

}  // namespace

}  // namespace pantin
