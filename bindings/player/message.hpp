#pragma once
#include <string>

namespace pantin::player {

/// Prints a line on standard error: "pantin: message", or as it is when it starts with a script's "file.lua:12: ".
void say(const std::string& message);

}  // namespace pantin::player
