// `pantin bench tables`: a table of 10⁶ rows and 10 columns as .csv and as .h5, its size, and how long it takes both ways.
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "bench/clock.hpp"
#include "player/bench.hpp"
#include "player/columns.hpp"
#include "player/csv.hpp"
#include "player/hdf5_table.hpp"
#include "player/output.hpp"
#include "scene/files.hpp"

using namespace pantin;

namespace {

constexpr std::size_t rows = 1'000'000, probes = 9;

/// As of a run: the times of steps, and what swings.
std::vector<player::Column> swinging() {
  std::vector<player::Column> columns{{"time", "s", std::vector<double>(rows), false}};
  for (std::size_t p = 0; p < probes; p++)
    columns.push_back({"probe " + std::to_string(p + 1), "", std::vector<double>(rows), false});
  for (std::size_t c = 0; c < columns.size(); c++)
    for (std::size_t i = 0; i < rows; i++) {
      const double t = static_cast<double>(i + 1) / 240.0;
      std::get<std::vector<double>>(columns[c].cells)[i] = c == 0 ? t : std::sin(t * std::sqrt(static_cast<double>(c)));
    }
  return columns;
}

void bench_tables(const player::BenchOptions&) {
  const std::vector<player::Column> columns = swinging();
  std::printf("%zu rows, %zu columns, one thread's processor time\n%8s %10s %12s %12s\n", rows, columns.size(), "",
              "MB", "to write, s", "to read, s");
  for (const std::string ending : {".csv", ".h5"}) {
    if (ending == player::hdf5_ending && !player::has_hdf5()) continue;
    const std::string path = std::filesystem::temp_directory_path() / ("pantin-bench-table" + ending);
    const double start = now();
    player::Output file(path);
    file.write(player::table_content(path, columns));
    file.keep();
    const double written = now();
    const std::size_t read =
        ending == ".csv" ? player::read_csv(*file_content(path)).size() : player::read_hdf5(path).size();
    const double end = now();
    std::printf("%8s %10.1f %12.2f %12.2f\n", ending.c_str(),
                static_cast<double>(std::filesystem::file_size(path)) / 1e6, written - start, end - written);
    std::fflush(stdout);
    std::filesystem::remove(path);
    if (read == 0) return;
  }
}

const player::Register tables_benchmark({"tables", "tables of a million rows as .csv and .h5", bench_tables});

}  // namespace
