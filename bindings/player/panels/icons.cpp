#include "player/panels/icons.hpp"

#include <imgui.h>

#include <cmath>
#include <initializer_list>

namespace pantin::player {
namespace {

struct Pen {
  ImDrawList& list;
  ImVec2 middle;
  float size;  // [px] half
  ImU32 ink, ground;

  ImVec2 at(float x, float y) const { return {middle.x + x * size, middle.y + y * size}; }
  void bar(float x0, float y0, float x1, float y1) const { list.AddRectFilled(at(x0, y0), at(x1, y1), ink, 1.0f); }
  // Points right where `tip` > `back`, else left.
  void triangle(float back, float tip, float half) const {
    if (tip > back)
      list.AddTriangleFilled(at(back, -half), at(tip, 0), at(back, half), ink);
    else
      list.AddTriangleFilled(at(back, -half), at(back, half), at(tip, 0), ink);
  }
};

void draw_restart(const Pen& pen) {
  pen.list.PathArcTo(pen.middle, 0.62f * pen.size, -0.9f, 4.2f, 20);
  pen.list.PathStroke(pen.ink, 0, 0.24f * pen.size);
  const float x = 0.62f * std::cos(-0.9f), y = 0.62f * std::sin(-0.9f);
  pen.list.AddTriangleFilled(pen.at(x - 0.5f, y - 0.12f), pen.at(x + 0.12f, y - 0.5f), pen.at(x + 0.22f, y + 0.28f),
                             pen.ink);
}

void draw(Icon icon, const Pen& pen) {
  switch (icon) {
    case Icon::scenes:
      for (const float x : {-0.75f, 0.1f})
        for (const float y : {-0.7f, 0.12f}) pen.bar(x, y, x + 0.65f, y + 0.58f);
      break;
    case Icon::previous:
      pen.bar(-0.7f, -0.6f, -0.48f, 0.6f);
      pen.triangle(0.6f, -0.42f, 0.62f);
      break;
    case Icon::next:
      pen.triangle(-0.6f, 0.42f, 0.62f);
      pen.bar(0.48f, -0.6f, 0.7f, 0.6f);
      break;
    case Icon::restart: draw_restart(pen); break;
    case Icon::pause:
      pen.bar(-0.55f, -0.65f, -0.15f, 0.65f);
      pen.bar(0.15f, -0.65f, 0.55f, 0.65f);
      break;
    case Icon::play: pen.triangle(-0.5f, 0.7f, 0.75f); break;
    case Icon::step:
      pen.bar(-0.6f, -0.6f, -0.38f, 0.6f);
      pen.triangle(-0.2f, 0.7f, 0.62f);
      break;
    case Icon::slower:
      pen.triangle(0.0f, -0.75f, 0.5f);
      pen.triangle(0.75f, 0.0f, 0.5f);
      break;
    case Icon::faster:
      pen.triangle(-0.75f, 0.0f, 0.5f);
      pen.triangle(0.0f, 0.75f, 0.5f);
      break;
    case Icon::picture:
      pen.bar(-0.78f, -0.42f, 0.78f, 0.6f);
      pen.bar(-0.3f, -0.68f, 0.3f, -0.4f);
      pen.list.AddCircleFilled(pen.at(0.0f, 0.1f), 0.34f * pen.size, pen.ground);
      pen.list.AddCircleFilled(pen.at(0.0f, 0.1f), 0.18f * pen.size, pen.ink);
      break;
    case Icon::film: pen.list.AddCircleFilled(pen.middle, 0.5f * pen.size, pen.ink); break;
    case Icon::end_film: pen.bar(-0.5f, -0.5f, 0.5f, 0.5f); break;
    case Icon::panels:
      for (const float y : {-0.5f, 0.0f, 0.5f}) pen.bar(-0.7f, y - 0.1f, 0.7f, y + 0.12f);
      break;
  }
}

}  // namespace

bool icon_button(Icon icon, const char* about) {
  const bool films = icon == Icon::end_film;
  const ImU32 ink = films ? ImGui::GetColorU32(ImVec4(0.85f, 0.2f, 0.2f, 1.0f)) : ImGui::GetColorU32(ImGuiCol_Text);
  const float side = 1.75f * ImGui::GetFontSize();
  const ImVec2 from = ImGui::GetCursorScreenPos();
  ImGui::PushID(static_cast<int>(icon));
  const bool pressed = ImGui::InvisibleButton("icon", {side, side});
  ImGui::PopID();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (ImGui::IsItemHovered()) {
    const ImU32 ground = ImGui::GetColorU32(ImGui::IsItemActive() ? ImGuiCol_ButtonActive : ImGuiCol_ButtonHovered);
    list.AddRectFilled(from, {from.x + side, from.y + side}, ground, 0.25f * side);
    ImGui::SetTooltip("%s", about);
  }
  draw(icon,
       {list, {from.x + 0.5f * side, from.y + 0.5f * side}, 0.3f * side, ink, ImGui::GetColorU32(ImGuiCol_WindowBg)});
  return pressed;
}

}  // namespace pantin::player
