#pragma once
#include <string>
#include <vector>

#include "base/shared_list.hpp"
#include "player/columns.hpp"
#include "world/world.hpp"

namespace pantin::player {

/// The times of the steps, for a table of the probes.
struct Times {
  std::uint64_t first_step = 0;  ///< steps done before the first of them
  SharedList values;             ///< [s] (steps)
  /// Call it after each step. Where a script went back to another step, later ones are dropped.
  void add(const World& world);
};

/// How many rows a table has, and what they tell of the steps between.
struct TableRows {
  double every = 0.0;  ///< [s] simulated from row to row, the last step's too; 0: each step
  std::vector<std::string> when =
      {};  ///< probes: a row also where one of them changed; without `every` there alone, and
           ///< where they are first known and at the last step
  std::vector<std::string> reductions = {};  ///< of `reduction_names`: more columns, of the steps since the row before
};
inline constexpr const char* reduction_names[] = {"least", "largest", "mean", "rms"};

/// `time` and the probes, a row per step unless `rows` says less; a probe that was added later is not known before.
std::vector<Column> probe_columns(const Times& times, const std::vector<Probe>& probes, const TableRows& rows = {});
/// The same, comma-separated.
std::string probe_table(const Times& times, const std::vector<Probe>& probes, const TableRows& rows = {});

}  // namespace pantin::player
