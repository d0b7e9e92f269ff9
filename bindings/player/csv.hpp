#pragma once
#include <string>

namespace pantin::player {

/// A cell of comma-separated values, in quotes where it needs them.
std::string csv_cell(const std::string& text);
/// The shortest text that reads back as the same double.
std::string number_text(double value);

}  // namespace pantin::player
