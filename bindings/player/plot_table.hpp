#pragma once
// `pantin plot`: columns of a table as a picture.
#include <string>
#include <vector>

namespace pantin::player {

struct PlotOptions {
  std::string table = {};             ///< .csv whose first row has names
  std::string x = {}, y = {};         ///< columns
  std::string by = {};                ///< a column whose values are a line each; empty: one line
  std::string color = {};             ///< a column that makes a heat map over x and y; empty: lines
  std::vector<std::string> log = {};  ///< those of these columns whose axis is logarithmic
  std::string title = {};             ///< empty: the table's name
  bool points = false;                ///< not joined by lines
  std::string out = {};               ///< .svg
};

/// Rows with an equal x, and an equal `by` or y of a heat map, are drawn as their mean. Rows without a number there are
/// left out, and counted. Returns the exit code. Throws UsageError.
int plot_table(const PlotOptions& options);

}  // namespace pantin::player
