// `pantin bench sharing`: what it costs to share out the cases of a sweep, and what processes gain, beside what two programs that know
// nothing of each other gain on this machine.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <future>
#include <string>
#include <vector>

#include "base/check.hpp"
#include "bench/clock.hpp"
#include "player/bench.hpp"
#include "player/csv.hpp"
#include "support/process.hpp"

using namespace pantin;

namespace {

const char* const chain = R"(
local n = scene:param("n", 1)
local last = scene:particle {}
scene:nail(last)
for i = 1, 24 do
  local next = scene:particle { at = vec(i, 0, 0) }
  scene:rod(last, next)
  last = next
end
scene:result("x", n)
)";

struct Swept {
  double clock = 0.0, cases = 0.0;  ///< [s] in all, and of the processor in the cases by themselves
};

Swept sweep(std::vector<std::string> before, int cases, const char* until, std::vector<std::string> more) {
  const support::Folder folder;
  support::write_file(folder / "chain.lua", chain);
  before.insert(before.end(), {std::filesystem::read_symlink("/proc/self/exe").string(), "sweep", "chain.lua", "--set",
                               text("n=1:", cases, ":", cases), "--until", until, "--timed", "--out", "t.csv"});
  before.insert(before.end(), more.begin(), more.end());
  const double begin = now(2);
  const support::Finished run = support::finish(
      {before,
       {"OMPI_ALLOW_RUN_AS_ROOT=1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1", "OMPI_MCA_rmaps_base_oversubscribe=1"},
       folder.path,
       -1});
  Swept swept{now(2) - begin, 0.0};
  require(run.code == 0, "the sweep ended with ", run.code, ": ", run.out, run.err);
  const auto rows = player::read_csv(support::read_file(folder / "t.csv"));
  const auto& names = rows.at(0);
  const std::size_t column = static_cast<std::size_t>(std::ranges::find(names, "seconds") - names.begin());
  for (std::size_t row = 1; row < rows.size(); row++) swept.cases += std::stod(rows[row].at(column));
  return swept;
}

/// Of the cases between few and many, so that to start the processes is not counted.
void print_sharing(const char* name, const std::vector<std::string>& before, const std::vector<std::string>& more) {
  constexpr int few = 100, many = 1100;
  const Swept a = sweep(before, few, "3", more), b = sweep(before, many, "3", more);
  const double cases = (b.cases - a.cases) / (many - few), all = (b.clock - a.clock) / (many - few);
  std::printf("%-28s %10.3f %14.3f %8.2f %%\n", name, 1e3 * cases, 1e3 * (all - cases), 100.0 * (all / cases - 1.0));
  std::fflush(stdout);
}

void bench_sweep(const player::BenchOptions&) {
  std::printf("%-28s %10s %14s %10s\n", "one process runs cases", "ms a case", "ms beside it", "part");
  print_sharing("pantin sweep --jobs 1", {}, {"--jobs", "1"});
  print_sharing("mpirun -n 2 pantin sweep", {"mpirun", "-n", "2"}, {});
  std::printf("\n%-20s %8s %8s %8s %26s %24s\n", "1100 short cases", "1 job, s", "2 jobs, s", "ratio",
              "two programs at once, s", "ratio that these have");
  const auto alone = [] { return sweep({}, 1100, "0.5", {"--jobs", "1"}).clock; };
  for (int pair = 0; pair < 5; pair++) {
    const double one = alone(), two = sweep({}, 1100, "0.5", {"--jobs", "2"}).clock;
    const double begin = now(2);
    std::future<double> other = std::async(std::launch::async, alone);
    alone();
    other.get();
    const double both = now(2) - begin;
    std::printf("%-20s %8.2f %8.2f %8.2f %26.2f %24.2f\n", "", one, two, one / two, both, 2.0 * one / both);
  }
}

const player::Register sweep_benchmark(
    {"sharing",
     "the cost of sharing out cases of 10 ms, alone and under mpirun; two processes beside one, and beside "
     "two programs",
     bench_sweep});

}  // namespace
