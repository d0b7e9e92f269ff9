#pragma once
#include <vector>

#include "scene/scene.hpp"
#include "view/overlay.hpp"

namespace pantin::player {

/// What the scene drew in its last step, written over other marks, so that nothing is allocated for the texts.
void write_marks_of(const Scene& scene, std::vector<Mark>& marks);

}  // namespace pantin::player
