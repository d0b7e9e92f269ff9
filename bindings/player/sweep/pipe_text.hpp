#pragma once
// Texts of any length through a pipe.
#include <string>

namespace pantin::player {

/// False where the other end is closed.
bool write_text(int file, const std::string& text);
bool read_text(int file, std::string& text);

}  // namespace pantin::player
