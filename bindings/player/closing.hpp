#pragma once
#include <string>

#include "lua/scene.hpp"

namespace pantin::player {

/// A few lines on standard output at the end of a run, and the scene's warnings on standard error. `seconds` of wall time.
void print_closing(const lua::Scene& scene, const std::string& path, double seconds);

}  // namespace pantin::player
