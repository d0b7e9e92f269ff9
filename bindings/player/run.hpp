#pragma once
#include <optional>
#include <string>

#include "player/options.hpp"
#include "scene/scene.hpp"

namespace pantin::player {

/// [s] at which it ends: as wanted, else as the scene says now.
double end_of(const Scene& scene, std::optional<double> wanted);

/// `pantin run`: a scene without a window, to its outputs. Returns the exit code.
int run(const RunOptions& options, const std::string& home);

}  // namespace pantin::player
