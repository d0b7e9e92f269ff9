#include "player/bench.hpp"

#include <algorithm>
#include <iostream>

#include "scene/errors.hpp"

namespace pantin::player {

int bench(const BenchOptions& options) {
  const std::vector<std::string>& arguments = options.arguments;
  std::vector<Benchmark> all = benchmarks();
  std::sort(all.begin(), all.end(), [](const Benchmark& a, const Benchmark& b) { return a.name < b.name; });
  if (arguments.empty()) {
    if (all.empty()) throw UsageError("no benchmark is part of this program: ./pantin bench builds one with them");
    for (const Benchmark& benchmark : all) {
      std::cout << benchmark.name << ": " << benchmark.help << "\n" << std::flush;
      benchmark.run({{}, options.peers});
    }
    return 0;
  }
  auto found = std::find_if(all.begin(), all.end(), [&](const Benchmark& b) { return b.name == arguments[0]; });
  if (found == all.end()) {
    std::string known;
    for (const Benchmark& benchmark : all) known += (known.empty() ? "" : ", ") + benchmark.name;
    throw UsageError(text("there is no benchmark '", arguments[0], "'; there are: ",
                          known.empty() ? "none, in this program: ./pantin bench builds one with them" : known));
  }
  found->run({{arguments.begin() + 1, arguments.end()}, options.peers});
  return 0;
}

}  // namespace pantin::player
