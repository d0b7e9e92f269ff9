#pragma once
#include <string>

#include "player/options.hpp"

namespace pantin::player {

/// [s] of a run when neither the command line nor the scene says.
inline constexpr double usual_duration = 10.0;

/// `pantin run`: a scene without a window, to its outputs. Returns the exit code.
int run(const RunOptions& options, const std::string& home);

}  // namespace pantin::player
