#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace pantin::player {

/// A cell of comma-separated values, in quotes where it needs them.
std::string csv_cell(const std::string& text);
/// Rows of cells; a line break within quotes is of the cell.
std::vector<std::vector<std::string>> read_csv(const std::string& text);
/// The shortest text that reads back as the same double.
std::string number_text(double value);

/// 16 hexadecimal digits.
std::string hex_text(std::uint64_t value);
std::string hash_text(const std::string& text);

}  // namespace pantin::player
