#pragma once
#include <imgui.h>

#include <span>

namespace pantin {

/// Where DejaVu Sans is installed.
inline constexpr const char* font_paths[] = {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
                                             "/usr/share/fonts/TTF/DejaVuSans.ttf",
                                             "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf"};

/// Of windows that only show themselves: without frame, moving and focus.
inline constexpr ImGuiWindowFlags quiet_window = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                                                 ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav |
                                                 ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoSavedSettings;

/// Gives Dear ImGui's present context the first font that can be read, drawn with `scale` pixels in each px; where there
/// is none, tells so and takes the one that Dear ImGui brings along.
void load_panel_font(float scale, std::span<const char* const> paths = font_paths);
/// Colours and sizes of Dear ImGui's present context.
void set_panel_style(bool dark);
/// Of errors.
ImVec4 warning_ink(bool dark);

}  // namespace pantin
