#pragma once
// What one case of a sweep came to.
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "player/columns.hpp"
#include "player/sweep/cases.hpp"
#include "scene/options.hpp"

namespace pantin::player {

/// Names and texts of cells; numbers read back as the same doubles.
using Cells = std::vector<std::pair<std::string, std::string>>;

struct CaseRow {
  std::uint64_t number = 0;
  Cells told;         ///< the scene's results
  Cells measured;     ///< of `measures`, those that are known; one that failed has "error"
  Cells files;        ///< that it read, with a hash of each
  Cells probes = {};  ///< of each the last, least and largest value
};

/// Columns that every table has, in their order: `seconds` only where it is timed.
inline constexpr const char* measures[] = {
    "time",         "steps",          "hinge_gap",      "constraint", "penetration", "energy_error", "iterations",
    "halved_steps", "fallback_steps", "factorisations", "seconds",    "hash",        "error"};

/// Runs a case on one thread; what fails is told in its row.
CaseRow run_case(std::uint64_t number, const std::string& path, const SceneOptions& options,
                 std::optional<double> until, bool timed);

/// Why a case failed; empty: it did not.
std::string error_of(const CaseRow& row);
inline bool failed(const CaseRow& row) { return !error_of(row).empty(); }

/// The column of what the scene told by a name, which may be one of the table's own. Two names have two columns.
std::string told_column(const Cases& cases, const std::string& name);

/// A row per case: its number, what is set, what the scene told, what was measured.
std::vector<Column> case_columns(const Cases& cases, const std::map<std::uint64_t, CaseRow>& rows, bool timed);

}  // namespace pantin::player
