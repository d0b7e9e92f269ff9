#include "view/palette.hpp"

#include <imgui.h>
#include <imgui_internal.h>

#include <string>

#include "base/check.hpp"
#include "view/keys.hpp"
#include "view/panel_style.hpp"

namespace pantin {

namespace {

constexpr float icon_size = 1.5f;  // times the text's

bool icon_there(const char* icon) {
  unsigned letter = 0;
  ImTextCharFromUtf8(&letter, icon, nullptr);
  return ImGui::GetFont()->FindGlyphNoFallback(static_cast<ImWchar>(letter)) != nullptr;
}

/// A button that is marked where it is the chosen one; hint() says more.
template <class Hint>
bool button(const char* icon, const char* name, Hint hint, bool chosen, bool enabled, ImVec2 size) {
  const bool drawn = icon_there(icon);
  const char* const label = drawn ? icon : name;
  if (!drawn) {
    ImGui::SetWindowFontScale(1.0f);
    size.x = ImGui::CalcTextSize(name).x + 0.4f * size.y;
  }
  if (chosen) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
  if (!enabled) ImGui::BeginDisabled();
  ImGui::PushID(name);
  const bool pressed = ImGui::Button(label, size);
  ImGui::PopID();
  if (!drawn) ImGui::SetWindowFontScale(icon_size);
  if (!enabled) ImGui::EndDisabled();
  if (chosen) ImGui::PopStyleColor();
  if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) ImGui::SetTooltip("%s", hint().c_str());
  return pressed;
}

PaletteWish draw_undo(const UndoState& state, float side) {
  PaletteWish wish;
  const auto hint = [&](const char* does, std::string_view act, const char* key) {
    if (state.obstacle) return state.obstacle();
    return act.empty() ? text("nothing to ", does) : text(does, ": ", act, " (", key, ")");
  };
  const bool can = !state.obstacle;
  ImGui::SameLine(0.0f, 0.4f * side);
  wish.undo = button("\u21b6", "undo", [&] { return hint("undo", state.undo, "ctrl+z"); }, false,
                     can && !state.undo.empty(), {side, side});
  ImGui::SameLine();
  wish.redo = button("\u21b7", "redo", [&] { return hint("redo", state.redo, "ctrl+shift+z"); }, false,
                     can && !state.redo.empty(), {side, side});
  return wish;
}

/// Returns the height of their upper edge.
float draw_variants(ToolChoice& choice, float middle, float bottom) {
  const Tool& tool = choice.tool();
  if (tool.variants.empty()) return bottom;
  ImGui::SetNextWindowPos({middle, bottom}, ImGuiCond_Always, {0.5f, 1.0f});
  ImGui::Begin("variants", nullptr, quiet_window | ImGuiWindowFlags_NoBackground);
  for (std::size_t i = 0; i < tool.variants.size(); i++) {
    if (i > 0) ImGui::SameLine();
    const bool chosen = i == choice.variant;
    if (chosen) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
    if (ImGui::Button(tool.variants[i])) choice.variant = i;
    if (chosen) ImGui::PopStyleColor();
  }
  const float top = ImGui::GetWindowPos().y;
  ImGui::End();
  return top;
}

/// A text on a ground, over panels too.
void draw_label(const std::string& label, ImVec2 at, ImVec2 size, float pad) {
  ImDrawList& list = *ImGui::GetForegroundDrawList();
  list.AddRectFilled({at.x - pad, at.y - pad}, {at.x + size.x + pad, at.y + size.y + pad},
                     ImGui::GetColorU32(ImGuiCol_WindowBg), pad);
  list.AddText(nullptr, 0.0f, at, ImGui::GetColorU32(ImGuiCol_Text), label.c_str(), nullptr, size.x + 1.0f);
}

void draw_told(const std::string& told, float middle, float bottom, float scale) {
  if (told.empty()) return;
  const float pad = 7.0f * scale;
  const ImVec2 size = ImGui::CalcTextSize(told.c_str(), nullptr, false, 2.0f * middle - 4.0f * pad);
  draw_label(told, {middle - 0.5f * size.x, bottom - size.y - 2.0f * pad}, size, pad);
}

/// To the left of the tools: "make rod (8)".
void draw_chosen(const ToolChoice& choice, ImVec2 corner, float height, float scale) {
  const Tool& tool = choice.tool();
  const char* const variant = tool.variants.empty() ? "" : tool.variants[choice.variant];
  const std::string label = text(tool.name, *variant ? " " : "", variant, " (",
                                 key_for(KeyUse::tool, static_cast<std::size_t>(tool.kind)), ")");
  const float pad = 5.0f * scale;
  const ImVec2 size = ImGui::CalcTextSize(label.c_str());
  const ImVec2 at = {corner.x - size.x - 3.0f * pad, corner.y + 0.5f * (height - size.y)};
  if (at.x > 2.0f * pad) draw_label(label, at, size, pad);
}

}  // namespace

PaletteWish draw_palette(ToolChoice& choice, const UndoState& undo, const std::string& told, float width,
                         float height) {
  const float scale = ImGui::GetFontSize() / 14.0f;
  const float side = 32.0f * scale, bottom = height - 44.0f * scale;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {4.0f * scale, 4.0f * scale});
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {2.0f * scale, 2.0f * scale});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {2.0f * scale, 2.0f * scale});
  ImGui::SetNextWindowPos({0.5f * width, bottom}, ImGuiCond_Always, {0.5f, 1.0f});
  ImGui::SetNextWindowBgAlpha(0.72f);
  ImGui::Begin("tools", nullptr, quiet_window);
  ImGui::SetWindowFontScale(icon_size);
  for (const Tool& tool : tools()) {
    if (&tool != &tools().front()) ImGui::SameLine();
    const bool chosen = tool.kind == choice.kind;
    const auto hint = [&] {
      return text(tool.name, " (", key_for(KeyUse::tool, static_cast<std::size_t>(tool.kind)), "): ", tool.help);
    };
    if (button(tool.icon, tool.name, hint, chosen, true, {side, side}) && !chosen) choice.choose(tool.kind);
  }
  const PaletteWish wish = draw_undo(undo, side);
  const ImVec2 corner = ImGui::GetWindowPos();
  const float tall = ImGui::GetWindowHeight();
  ImGui::End();
  ImGui::PopStyleVar(3);
  draw_chosen(choice, corner, tall, scale);
  draw_told(told, 0.5f * width, draw_variants(choice, 0.5f * width, corner.y), scale);
  return wish;
}

}  // namespace pantin
