#pragma once
#include <string>

#include "view/tools.hpp"

namespace pantin {

/// A row of buttons of the tools at the lower edge of a picture of that size [px], the chosen one marked, and what it can be
/// of; above it what hands were told last. Within a frame of Dear ImGui.
void draw_palette(ToolChoice& choice, const std::string& told, float width, float height);

}  // namespace pantin
