#pragma once
#include <vector>

#include "lua/scene.hpp"
#include "view/overlay.hpp"

namespace pantin::player {

/// What the scene drew in its last step, for the overlay.
std::vector<Mark> marks_of(const lua::Scene& scene);

}  // namespace pantin::player
