// `pantin bench reports`: what a report of each shipped scene takes, and the sentence in which it ends.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "player/bench.hpp"
#include "player/home.hpp"
#include "player/report.hpp"

using namespace pantin;

namespace {

std::vector<std::string> shipped_scenes(const std::string& home) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(home + "/scripts/scenes"))
    if (entry.path().extension() == ".lua") names.push_back(entry.path().stem());
  std::sort(names.begin(), names.end());
  return names;
}

void bench_reports(const player::BenchOptions& options) {
  const std::string home = player::find_home();
  const std::vector<std::string> names = options.arguments.empty() ? shipped_scenes(home) : options.arguments;
  std::printf("%-16s %12s %10s %6s\n", "scene", "processor, s", "clock, s", "runs");
  double most = 0.0;
  for (const std::string& name : names) {
    player::RunOptions scene;
    scene.scene = name;
    const auto start = std::chrono::steady_clock::now();
    const double begin = player::processor_time();
    const player::Study studied = player::study(scene, home, player::report_budget, [](const std::string&, double) {});
    const double spent = player::processor_time() - begin;
    const std::chrono::duration<double> clock = std::chrono::steady_clock::now() - start;
    most = std::max(most, spent);
    std::printf("%-16s %12.1f %10.1f %6zu  %s\n", name.c_str(), spent, clock.count(), studied.runs.size(),
                player::advice(studied).c_str());
    std::fflush(stdout);
  }
  std::printf("the longest takes %.0f s of one processor's time\n", most);
}

const player::Register reports_benchmark({"reports",
                                          "time that a report of each shipped scene takes; arguments: scenes",
                                          bench_reports});

}  // namespace
