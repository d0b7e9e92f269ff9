#pragma once
#include <imgui.h>

namespace pantin {

/// Colours and sizes of Dear ImGui's present context, and its font: DejaVu Sans where it is installed.
void load_panel_font(float scale);
void set_panel_style(float scale, bool dark);
/// Of errors.
ImVec4 warning_ink(bool dark);

}  // namespace pantin
