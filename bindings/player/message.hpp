#pragma once
#include <cstddef>
#include <string>

namespace pantin::player {

/// Prints a line on standard error: "pantin: message", or as it is when it starts with a script's "file.lua:12: ".
void say(const std::string& message);
/// "1 probe", "2 probes".
std::string amount(std::size_t count, const char* one, const char* many);

}  // namespace pantin::player
