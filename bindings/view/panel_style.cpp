#include "view/panel_style.hpp"

#include <cmath>
#include <cstring>
#include <iostream>
#include <optional>
#include <string>
#include <string_view>

#include "scene/files.hpp"

namespace pantin {
namespace {

constexpr float letter_height = 14.0f;  // [px]

/// By how it begins: of anything else, Dear ImGui would end the program.
bool is_font(std::string_view content) {
  const std::string_view sign = content.substr(0, 4);
  return sign == std::string_view("\0\1\0\0", 4) || sign == "true" || sign == "OTTO" || sign == "ttcf";
}

/// ImGui ends the program over a file that it cannot read.
bool add_font(const char* path, float size, const ImWchar* ranges) {
  const std::optional<std::string> content = file_content(path);
  if (!content || !is_font(*content)) return false;
  void* const kept = ImGui::MemAlloc(content->size());
  std::memcpy(kept, content->data(), content->size());
  return ImGui::GetIO().Fonts->AddFontFromMemoryTTF(kept, static_cast<int>(content->size()), size, nullptr, ranges);
}

ImVec4 with_opacity(ImVec4 color, float opacity) { return {color.x, color.y, color.z, opacity}; }

}  // namespace

ImVec4 warning_ink(bool dark) { return dark ? ImVec4(1.0f, 0.52f, 0.44f, 1.0f) : ImVec4(0.72f, 0.16f, 0.14f, 1.0f); }

void load_panel_font(float scale, std::span<const char* const> paths) {
  static const ImWchar ranges[] = {0x20,   0xff,   0x370,  0x3ff,  0x2010, 0x2027, 0x2070, 0x209f, 0x2190, 0x21ff,
                                   0x2200, 0x22ff, 0x25b6, 0x25b6, 0x25cf, 0x25cf, 0x2600, 0x27bf, 0};
  ImGuiIO& io = ImGui::GetIO();
  const float size = std::round(letter_height * scale);
  for (const char* path : paths) {
    io.Fonts->Clear();
    io.FontGlobalScale = letter_height / size;
    if (add_font(path, size, ranges) && io.Fonts->Build()) return;
  }
  std::cerr
      << "pantin: the window's font is not here, and a plain one without signs is used: install fonts-dejavu-core\n";
  io.Fonts->Clear();
  io.FontGlobalScale = 1.0f;
  io.Fonts->AddFontDefault();
}

void set_panel_style(bool dark) {
  const ImVec4 ink = dark ? ImVec4(0.93f, 0.91f, 0.87f, 0.95f) : ImVec4(0.20f, 0.18f, 0.16f, 0.92f);
  const ImVec4 paper = dark ? ImVec4(0.13f, 0.135f, 0.15f, 0.92f) : ImVec4(1.0f, 0.985f, 0.96f, 0.92f);
  const ImVec4 field = dark ? ImVec4(0.24f, 0.245f, 0.27f, 0.95f) : ImVec4(0.925f, 0.895f, 0.845f, 0.95f);
  const ImVec4 warm = dark ? ImVec4(0.52f, 0.34f, 0.18f, 1.0f) : ImVec4(0.98f, 0.86f, 0.72f, 1.0f);
  const ImVec4 hot = dark ? ImVec4(0.82f, 0.50f, 0.24f, 1.0f) : ImVec4(0.92f, 0.60f, 0.34f, 1.0f);
  ImGuiStyle s;
  dark ? ImGui::StyleColorsDark(&s) : ImGui::StyleColorsLight(&s);
  s.WindowRounding = s.PopupRounding = 8.0f;
  s.FrameRounding = s.GrabRounding = 6.0f;
  s.WindowPadding = {14.0f, 10.0f};
  s.FramePadding = {8.0f, 4.0f};
  s.ItemSpacing = {8.0f, 6.0f};
  s.WindowBorderSize = s.PopupBorderSize = 0.0f;
  s.WindowMenuButtonPosition = ImGuiDir_None;
  s.ScrollbarSize = 11.0f;
  ImVec4* c = s.Colors;
  c[ImGuiCol_Text] = ink;
  c[ImGuiCol_TextDisabled] = with_opacity(ink, 0.62f);
  c[ImGuiCol_WindowBg] = paper;
  c[ImGuiCol_PopupBg] = with_opacity(paper, 0.98f);
  c[ImGuiCol_TitleBg] = c[ImGuiCol_TitleBgActive] = c[ImGuiCol_TitleBgCollapsed] = paper;
  c[ImGuiCol_FrameBg] = field;
  c[ImGuiCol_Button] = field;
  c[ImGuiCol_FrameBgHovered] = c[ImGuiCol_ButtonHovered] = c[ImGuiCol_HeaderHovered] = warm;
  c[ImGuiCol_FrameBgActive] = warm;
  c[ImGuiCol_Header] = field;
  c[ImGuiCol_ButtonActive] = c[ImGuiCol_HeaderActive] = hot;
  c[ImGuiCol_SliderGrab] = c[ImGuiCol_SliderGrabActive] = c[ImGuiCol_CheckMark] = hot;
  c[ImGuiCol_Separator] = with_opacity(ink, 0.15f);
  c[ImGuiCol_TextSelectedBg] = with_opacity(hot, 0.45f);
  c[ImGuiCol_ScrollbarBg] = {0, 0, 0, 0};
  c[ImGuiCol_ResizeGrip] = with_opacity(ink, 0.12f);
  ImGui::GetStyle() = s;
}

}  // namespace pantin
