// `pantin bench edits`: what an edit costs until the next step is done, beyond a normal step, at 1/240 s.
#include <algorithm>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "base/check.hpp"
#include "bench/clock.hpp"
#include "player/bench.hpp"
#include "player/machine.hpp"
#include "step/step.hpp"
#include "support/cases.hpp"

using namespace pantin;

namespace {

constexpr int warm = 60, repetitions = 25, normal_steps = 5;

struct EditBench {
  std::string name;
  std::function<void(World&)> make;
  std::function<void(World&, int repetition)> edit;
};

struct Cost {
  double normal = 0.0, beyond = 0.0;  ///< [s] medians
  double iterations = 0.0;            ///< of the step after the edit, mean
  double factors = 0.0;               ///< the same
};

double timed(World& world, const std::function<void()>& edit) {
  const double start = now();
  edit();
  step(world);
  return now() - start;
}

double middle(std::vector<double> list) {
  std::nth_element(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(list.size() / 2), list.end());
  return list[list.size() / 2];
}

/// Each edit stands between normal steps, with whose median it is compared.
Cost measure(const EditBench& bench) {
  World world;
  bench.make(world);
  for (int i = 0; i < warm; i++) step(world);
  std::vector<double> normal, beyond;
  Cost cost;
  for (int i = 0; i < repetitions; i++) {
    std::vector<double> around;
    const auto step_normally = [&] {
      for (int k = 0; k < normal_steps; k++) around.push_back(timed(world, [] {}));
    };
    step_normally();
    const Stats before = world.stats;
    const double edited = timed(world, [&] { bench.edit(world, i); });
    cost.iterations += static_cast<double>(world.stats.newton_iterations - before.newton_iterations);
    cost.factors += static_cast<double>(world.stats.factorisations - before.factorisations);
    step_normally();
    require(world.failure.empty(), bench.name, ": ", world.failure);
    normal.push_back(middle(around));
    beyond.push_back(edited - normal.back());
  }
  cost.normal = middle(normal);
  cost.beyond = middle(beyond);
  cost.iterations /= repetitions;
  cost.factors /= repetitions;
  return cost;
}

/// A hinge in the middle of the chain is cut and made again.
void rejoin(World& world, cases::Chain& chain, int repetition) {
  ParticleId& hinge = chain.hinges[chain.hinges.size() / 2 + static_cast<std::size_t>(repetition)];
  const std::vector<PointId> members = world.particles[hinge].points;
  cut(world, hinge);
  hinge = add_hinge(world, members);
}

/// Edits of a chain of 1000 links, or of the first of 500 chains of 20.
std::vector<EditBench> edits_of(const std::string& scene, int chains, int links) {
  const auto list = std::make_shared<std::vector<cases::Chain>>();
  const auto make = [=](World& world) {
    list->clear();
    for (int i = 0; i < chains; i++) list->push_back(cases::add_chain(world, {.links = links, .start = vec(0, 0, i)}));
  };
  const auto of = [=](int repetition) -> cases::Chain& {
    return (*list)[static_cast<std::size_t>(chains == 1 ? 0 : repetition)];
  };
  const auto body = [=](int repetition) { return of(repetition).bodies[static_cast<std::size_t>(links / 2)]; };
  const auto late = [=](int repetition) {  // of one chain each time another hinge, from the end
    const auto n = static_cast<std::size_t>(chains == 1 ? repetition : links / 2);
    return of(repetition).hinges.size() - 1 - n;
  };
  return {
      {scene + ": a hinge cut and made again", make,
       [=](World& world, int i) { rejoin(world, of(i), chains == 1 ? i : 0); }},
      {scene + ": a hinge cut", make, [=](World& world, int i) { cut(world, of(i).hinges[late(i)]); }},
      {scene + ": a body kicked", make, [=](World& world, int i) { kick(world, body(i), vec(0, 0, 1)); }},
      {scene + ": a velocity set", make,
       [=](World& world, int i) { set_velocity(world, body(i), vec(0, 0.1 * i, 0)); }},
      {scene + ": a mass set", make, [=](World& world, int i) { set_own_mass(world, body(i), 1.0 + 0.01 * i); }},
  };
}

void bench_edits(const player::BenchOptions&) {
  std::printf("at 1/240 s, one thread's processor time, medians of %d edits\n", repetitions);
  std::printf("%-46s %12s %12s %8s %12s %10s %16s\n", "", "us/step", "us beyond", "ratio", "iterations", "factors",
              "3x3 products");
  std::vector<EditBench> all = edits_of("1 chain of 1000", 1, 1000);
  for (EditBench& bench : edits_of("500 chains of 20", 500, 20)) all.push_back(std::move(bench));
  for (const EditBench& bench : all) {
    const Cost cost = measure(bench);
    std::printf("%-46s %12.1f %12.1f %8.2f %12.1f %10.1f %16.0f\n", bench.name.c_str(), 1e6 * cost.normal,
                1e6 * cost.beyond, cost.beyond / cost.normal, cost.iterations, cost.factors,
                1e9 * cost.beyond / player::product_time());
    std::fflush(stdout);
  }
}

const player::Register edits_benchmark({"edits", "what an edit costs beyond a normal step", bench_edits});

}  // namespace
