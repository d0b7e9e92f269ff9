#pragma once
// A table as its columns, and the files that it may be written as.
#include <string>
#include <variant>
#include <vector>

namespace pantin::player {

struct Column {
  std::string name;
  std::string unit;  ///< empty: not known, or none
  /// (rows) Of numbers one that is not known is NaN, an empty cell.
  std::variant<std::vector<double>, std::vector<std::string>> cells;
  bool text_alone = false;  ///< its texts are no numbers, even if they look so, as hashes may
};

/// Comma-separated, names first. Numbers read back as the same doubles.
std::string csv_text(const std::vector<Column>& columns);

/// What a file of this name is to hold: HDF5 for .h5, else comma-separated values. Throws Error.
std::string table_content(const std::string& path, const std::vector<Column>& columns);

}  // namespace pantin::player
