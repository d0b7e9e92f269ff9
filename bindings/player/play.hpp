#pragma once
#include <string>

#include "player/options.hpp"

namespace pantin::player {

/// `pantin play`: a scene in a window; without a display, a headless run to a picture and a film. Returns the exit code.
int play(const RunOptions& options, const std::string& home);

}  // namespace pantin::player
