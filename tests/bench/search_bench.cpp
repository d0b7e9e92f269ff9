// `pantin bench search [POINTS]`: how many cases `sweep --best` needs, beside a Latin hypercube and NLopt's methods alone.
#include <algorithm>
#include <cstdio>
#include <nlopt.hpp>

#include "base/check.hpp"
#include "player/bench.hpp"
#include "player/sweep/cases.hpp"
#include "support/search_cases.hpp"

using namespace pantin;

namespace {

using support::CubePoint, support::Searched;

constexpr std::uint64_t trials = 40;

struct Asking {
  const Searched& function;
  CubePoint place;
  std::uint64_t asked = 0, points = 0, needed = 0;
};

double cost(const std::vector<double>& at, std::vector<double>&, void* data) {
  Asking& asking = *static_cast<Asking*>(data);
  if (asking.asked == asking.points || asking.needed <= asking.points) throw nlopt::forced_stop();
  asking.asked++;
  const double value = asking.function.value(at, asking.place);
  if (value >= asking.function.goal) asking.needed = asking.asked;
  return std::isfinite(value) ? -value : 1e300;
}

/// One method, point after point, begun again elsewhere where it has converged.
std::uint64_t points_by(nlopt::algorithm method, const Searched& function, std::uint64_t trial, std::uint64_t points) {
  Asking asking{function, support::place_of(function, trial), 0, points, points + 1};
  Random random{trial, 2000};
  nlopt::srand(trial);
  for (std::uint64_t last = points; asking.asked < points && asking.needed > points && last != asking.asked;) {
    last = asking.asked;
    CubePoint at(function.dimensions);
    for (double& x : at) x = random.uniform();
    nlopt::opt search(method, static_cast<unsigned>(at.size()));
    nlopt::opt local(nlopt::LN_SBPLX, static_cast<unsigned>(at.size()));
    for (nlopt::opt* each : {&search, &local}) {
      each->set_initial_step(0.25);
      each->set_xtol_abs(1e-4);
    }
    search.set_lower_bounds(0.0);
    search.set_upper_bounds(1.0);
    if (method == nlopt::G_MLSL_LDS) search.set_local_optimizer(local);
    search.set_min_objective(cost, &asking);
    double least = 0.0;
    try {
      search.optimize(at, least);
    } catch (const std::exception&) {}
  }
  return asking.needed;
}

template <class Needed>
void print_row(const char* name, std::uint64_t points, Needed needed) {
  std::printf("%-14s", name);
  for (const Searched& function : support::searched) {
    std::vector<std::uint64_t> all;
    for (std::uint64_t trial = 1; trial <= trials; trial++) all.push_back(needed(function, trial));
    std::ranges::sort(all);
    const auto found = std::ranges::count_if(all, [&](std::uint64_t n) { return n <= points; });
    char median[32] = "-";
    if (all[trials / 2] <= points)
      std::snprintf(median, sizeof median, "%llu", static_cast<unsigned long long>(all[trials / 2]));
    std::printf("  %9s in %2lld", median, static_cast<long long>(found));
  }
  std::printf("\n");
  std::fflush(stdout);
}

void print_table(std::uint64_t points) {
  std::printf(
      "of %llu cases: the median that is needed, in how many of %llu trials they were enough;\ntime: in cases one "
      "after the other, by so many processors\n%-14s",
      static_cast<unsigned long long>(points), static_cast<unsigned long long>(trials), "");
  for (const Searched& function : support::searched) std::printf("%17s", function.name.c_str());
  std::printf("\n");
  print_row("hypercube", points,
            [&](const Searched& f, std::uint64_t trial) { return support::points_of_hypercube(f, trial, points); });
  print_row("sweep --best", points,
            [&](const Searched& f, std::uint64_t trial) { return support::points_needed(f, trial, points); });
  for (const std::size_t processors : {1u, 2u, 4u, 8u, 16u, 64u})
    print_row(text("  time of ", processors).c_str(), points, [&](const Searched& f, std::uint64_t trial) {
      return support::rounds_needed(f, trial, points, processors);
    });
  constexpr std::pair<const char*, nlopt::algorithm> methods[] = {{"Nelder-Mead", nlopt::LN_NELDERMEAD},
                                                                  {"Subplex", nlopt::LN_SBPLX},
                                                                  {"COBYLA", nlopt::LN_COBYLA},
                                                                  {"BOBYQA", nlopt::LN_BOBYQA},
                                                                  {"CRS2", nlopt::GN_CRS2_LM},
                                                                  {"ISRES", nlopt::GN_ISRES},
                                                                  {"ESCH", nlopt::GN_ESCH},
                                                                  {"DIRECT-L", nlopt::GN_DIRECT_L},
                                                                  {"MLSL", nlopt::G_MLSL_LDS}};
  for (const auto& [name, method] : methods)
    print_row(name, points,
              [&, m = method](const Searched& f, std::uint64_t trial) { return points_by(m, f, trial, points); });
}

void bench_search(const player::BenchOptions& options) {
  if (!options.arguments.empty()) return print_table(std::stoull(options.arguments[0]));
  for (const std::uint64_t points : {100u, 200u, 500u, 1000u}) print_table(points);
}

const player::Register search_benchmark({"search", "cases that sweep --best needs", bench_search});

}  // namespace
