#pragma once
#include <string>
#include <utility>
#include <vector>

namespace pantin::player {

struct BenchOptions {
  std::vector<std::string> arguments;  ///< of the benchmark
  bool peers = false;                  ///< measure other engines too, in the same run
};

/// A benchmark, run by `pantin bench NAME ARGUMENTS…`; prints a table.
struct Benchmark {
  std::string name;
  std::string help;
  void (*run)(const BenchOptions& options);
};

inline std::vector<Benchmark>& benchmarks() {
  static std::vector<Benchmark> all;
  return all;
}

/// Makes a benchmark known: one static object in its own file.
struct Register {
  explicit Register(Benchmark benchmark) { benchmarks().push_back(std::move(benchmark)); }
};

/// `pantin bench`: the first argument names one, the rest are its own; without arguments all run. Throws UsageError.
int bench(const BenchOptions& options);

}  // namespace pantin::player
