// `pantin bench chain`: time per hinge and step of chains of growing length at 1/240 s: implicitly, with Newton iterations, and
// by their trees, with evaluations.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

#include "base/check.hpp"
#include "player/bench.hpp"
#include "player/machine.hpp"
#include "step/step.hpp"
#include "support/cases.hpp"
#include "support/watch.hpp"

using namespace pantin;

namespace {

constexpr int warm_steps = 60, measured_steps = 240;

struct ChainRun {
  double step = 0.0;            ///< [ns]
  double iterations = 0.0;      ///< per step
  double factorisations = 0.0;  ///< per step
  double evaluations = 0.0;     ///< per step
};

/// Runs the same stretch several times; each window of it counts with the fastest of its runs.
ChainRun measure(int links, Integrator integrator) {
  const int window = std::clamp(20000 / links, 12, measured_steps), windows = measured_steps / window;
  std::vector<double> best(static_cast<std::size_t>(windows), std::numeric_limits<double>::infinity());
  ChainRun measured;
  const double begin = player::thread_time();
  for (int run = 0; run < 3 || (run < 100 && player::thread_time() - begin < 3e8); run++) {
    World world;
    world.settings.integrator = integrator;
    cases::add_chain(world, {.links = links});
    for (int i = 0; i < warm_steps; i++) step(world);
    const Stats before = world.stats;
    for (double& time : best) {
      const double start = player::thread_time();
      for (int i = 0; i < window; i++) step(world);
      time = std::min(time, player::thread_time() - start);
    }
    require(world.failure.empty(), "chain of ", links, " links: ", world.failure);
    const double steps = static_cast<double>(windows * window);
    measured.iterations = static_cast<double>(world.stats.newton_iterations - before.newton_iterations) / steps;
    measured.factorisations = static_cast<double>(world.stats.factorisations - before.factorisations) / steps;
    measured.evaluations = static_cast<double>(world.stats.evaluations - before.evaluations) / steps;
  }
  for (const double time : best) measured.step += time / (windows * window);
  return measured;
}

std::vector<int> lengths(const std::vector<std::string>& arguments) {
  if (arguments.empty()) return {1, 3, 10, 31, 100, 300, 1000, 3000, 10000};
  std::vector<int> list;
  for (const std::string& argument : arguments) {
    int links = 0;
    const auto [end, error] = std::from_chars(argument.data(), argument.data() + argument.size(), links);
    require(error == std::errc() && end == argument.data() + argument.size() && links >= 1 && links <= 1000000,
            "bench chain: the number of links must be from 1 to 1000000, got '", argument, "'");
    list.push_back(links);
  }
  return list;
}

void bench_chain(const player::BenchOptions& options) {
  const std::vector<int> list = lengths(options.arguments);
  std::printf("chain at 1/240 s, from %.2f s to %.2f s, one thread's processor time\n", warm_steps / 240.0,
              (warm_steps + measured_steps) / 240.0);
  std::printf("%8s %14s %12s %12s %14s %12s %14s %12s\n", "links", "ns/hinge/step", "iterations", "factors",
              "ns/3x3 product", "us/step", "adaptive, ns", "evaluations");
  std::vector<double> links, times;
  for (const int n : list) {
    const ChainRun measured = measure(n, Integrator::verlet), tree = measure(n, Integrator::adaptive);
    std::printf("%8d %14.1f %12.2f %12.2f %14.2f %12.2f %14.1f %12.2f\n", n, measured.step / n, measured.iterations,
                measured.factorisations, player::product_time(), measured.step / 1e3, tree.step / n, tree.evaluations);
    std::fflush(stdout);
    if (n < 31) continue;
    links.push_back(n);
    times.push_back(measured.step);
  }
  for (; links.size() > 1; links.pop_back(), times.pop_back())
    std::printf("time of a step grows as links^%.3f, from %.0f to %.0f\n", exponent(links, times), links.front(),
                links.back());
}

const player::Register chain_benchmark({"chain", "time per hinge and step of a chain; arguments: numbers of links",
                                        bench_chain});

}  // namespace
