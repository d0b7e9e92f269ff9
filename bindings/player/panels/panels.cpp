#include "player/panels/panels.hpp"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cstdio>
#include <tuple>
#include <utility>

#include "player/panels/icons.hpp"
#include "view/keys.hpp"

namespace pantin::player {
namespace {

constexpr ImGuiWindowFlags bar_flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                                       ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav |
                                       ImGuiWindowFlags_NoFocusOnAppearing;

constexpr float above_tools = 84.0f;  // [px] at scale 1, from the bottom to over the tools

float scale() { return ImGui::GetFontSize() / 14.0f; }

/// Where the bar ends [px].
float below_bar() { return 10.0f * scale() + 1.75f * ImGui::GetFontSize() + 14.0f * scale(); }

/// Where the scene's title and buttons end, at the left edge [px].
float below_buttons(const Desk& desk) {
  const auto buttons = static_cast<float>(desk.scene.buttons().size());
  return 16.0f * scale() + 1.8f * ImGui::GetFontSize() + buttons * ImGui::GetFrameHeightWithSpacing() +
         (buttons > 0.0f ? 14.0f * scale() : 0.0f);
}

void gap() { ImGui::SameLine(0.0f, 0.8f * ImGui::GetFontSize()); }

/// A line of the list, with its key; true where it was pressed.
bool item(const char* name, KeyUse use, std::size_t which, bool on, const char* about) {
  const bool pressed = ImGui::MenuItem(name, key_for(use, which), on);
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", about);
  return pressed;
}

/// The next power of two above or below, or the end of the range.
double other_speed(double speed, bool faster) {
  return std::clamp(faster ? 2.0 * speed : 0.5 * speed, slowest, fastest);
}

}  // namespace

Panels::Panels() {
  for (std::size_t i = 0; i < slots_.size(); i++) {
    slots_[i].kind = &pane_kinds[i];
    slots_[i].open = pane_kinds[i].open;
  }
}

void Panels::toggle(std::size_t which) {
  Slot& slot = slots_.at(which);
  slot.open = hidden_ || !slot.open;
  hidden_ = false;
  std::erase(opened_, which);
  if (slot.open) opened_.push_back(which);
}

bool Panels::shows(std::string_view title) const {
  return !hidden_ &&
         std::ranges::any_of(slots_, [&](const Slot& slot) { return slot.open && title == slot.kind->title; });
}

bool Panels::close_last() {
  while (!hidden_ && !opened_.empty()) {
    Slot& slot = slots_[opened_.back()];
    opened_.pop_back();
    if (std::exchange(slot.open, false)) return true;
  }
  return false;
}

void Panels::hide() { hidden_ = !hidden_; }

void Panels::reset() {
  for (Slot& slot : slots_) {
    if (slot.pane) slot.pane->reset();
    slot.moved = false;  // it finds a place anew
    slot.height = 0.0f;
  }
}

void Panels::show(const std::string& title) {
  hidden_ = false;
  for (Slot& slot : slots_)
    if (title == slot.kind->title) slot.open = true;
}

void Panels::draw(Desk& desk) {
  if (hidden_) return;
  draw_bar(desk);
  shown_.clear();
  for (Slot& slot : slots_) {
    if (!slot.open) continue;
    if (!slot.pane) slot.pane = slot.kind->make();
    if (slot.pane->useful(desk)) shown_.push_back(&slot);
  }
  place(desk);
  for (Slot* slot : shown_) draw_pane(*slot, desk);
}

void Panels::draw_bar(Desk& desk) {
  const float edge = 10.0f * scale();
  ImGui::SetNextWindowPos({desk.width - edge, edge}, ImGuiCond_Always, {1.0f, 0.0f});
  ImGui::SetNextWindowBgAlpha(0.72f);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {6.0f * scale(), 3.0f * scale()});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {1.0f * scale(), 0.0f});
  ImGui::Begin("bar", nullptr, bar_flags);
  Wishes& wishes = desk.wishes;
  wishes.browse |= icon_button(Icon::scenes, "all scenes (n)");
  ImGui::SameLine();
  wishes.previous |= icon_button(Icon::previous, "the scene before (page up)");
  ImGui::SameLine();
  wishes.next |= icon_button(Icon::next, "the next scene (page down)");
  gap();
  wishes.restart |= icon_button(Icon::restart, "start again (r)");
  ImGui::SameLine();
  wishes.pause |= desk.paused ? icon_button(Icon::play, "run (space)") : icon_button(Icon::pause, "pause (space)");
  ImGui::SameLine();
  wishes.step |= icon_button(Icon::step, "one step (.)");
  gap();
  if (icon_button(Icon::slower, "slow motion (-)")) wishes.speed = other_speed(desk.speed, false);
  ImGui::SameLine();
  char speed[16];
  const double pace = desk.scene.pace() * desk.speed;
  std::snprintf(speed, sizeof speed, pace < 1.0 ? "1/%.3g ×" : "%.3g ×", pace < 1.0 ? 1.0 / pace : pace);
  const float wide = 3.4f * ImGui::GetFontSize();
  if (ImGui::InvisibleButton("speed", {wide, 1.75f * ImGui::GetFontSize()})) wishes.speed = 1.0;
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("back to the scene's own pace (0)");
  const ImVec2 from = ImGui::GetItemRectMin(), size = ImGui::CalcTextSize(speed);
  ImGui::GetWindowDrawList()->AddText(
      {from.x + 0.5f * (wide - size.x), from.y + 0.5f * (1.75f * ImGui::GetFontSize() - size.y)},
      ImGui::GetColorU32(desk.speed == 1.0 ? ImGuiCol_TextDisabled : ImGuiCol_Text), speed);
  ImGui::SameLine();
  if (icon_button(Icon::faster, "fast forward (+)")) wishes.speed = other_speed(desk.speed, true);
  gap();
  wishes.picture |= icon_button(Icon::picture, "take a picture (s)");
  ImGui::SameLine();
  wishes.film |=
      desk.filming ? icon_button(Icon::end_film, "end the film (F9)") : icon_button(Icon::film, "film the scene (F9)");
  gap();
  if (icon_button(Icon::panels, "panels (tab hides them), views, film")) ImGui::OpenPopup("panels");
  ImGui::PopStyleVar(2);
  draw_list(desk);
  ImGui::End();
}

void Panels::draw_list(Desk& desk) {
  ImGui::SetNextWindowPos({desk.width - 10.0f * scale(), below_bar()}, ImGuiCond_Always, {1.0f, 0.0f});
  if (!ImGui::BeginPopup("panels")) return;
  for (std::size_t i = 0; i < slots_.size(); i++) {
    const Slot& slot = slots_[i];
    if (item(slot.kind->title, KeyUse::panel, i, slot.open && !hidden_, slot.kind->about)) toggle(i);
  }
  ImGui::Separator();
  for (const NamedView& named : view_table())
    if (item(named.name, KeyUse::view, static_cast<std::size_t>(named.view), desk.views.on(named.view), named.help))
      desk.views.toggle(named.view);
  ImGui::Separator();
  desk.wishes.picture |= item("picture", KeyUse::picture, 0, false, "of the scene, as .png");
  desk.wishes.film |= item("film", KeyUse::film, 0, desk.filming, "the scene, until it is pressed again, as .mp4");
  ImGui::MenuItem("film panels too", nullptr, &desk.film_panels);
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("films show all that is on the screen");
  desk.wishes.save_state |=
      item("save", KeyUse::save_state, 0, false, "the state, as .pantin: the scene goes on from it");
  desk.wishes.save_scene |=
      item("save as Lua", KeyUse::save_scene, 0, false, "the script with what was built by hand, as a scene");
  desk.wishes.open_state |= item("open", KeyUse::open_state, 0, false, "the state that was saved last");
  ImGui::EndPopup();
}

/// Puts what no hand moved: the panels at the left edge under the scene's buttons, the others in columns from the right.
void Panels::place(const Desk& desk) {
  const float edge = 10.0f * scale();
  Board board{edge, desk.width - edge, below_bar(), desk.height - above_tools * scale(), 8.0f * scale()};
  board.title = ImGui::GetFrameHeight();
  tiles_.clear();
  put_.clear();
  for (Slot* slot : shown_) {
    // Dear ImGui moves a window that is dragged before its frame begins.
    const ImGuiWindow* window = ImGui::FindWindowByName(slot->kind->title);
    slot->moved |= window && slot->height > 0.0f && (window->Pos.x != slot->x || window->Pos.y != slot->y);
    const float width = slot->kind->width * scale();
    if (slot->kind->left) {
      if (!slot->moved) std::tie(slot->x, slot->y) = std::pair(edge, below_buttons(desk));
      board.left = std::max(board.left, edge + width + board.gap);
      board.under = slot->y + slot->height + board.gap;
    } else if (!slot->moved) {
      tiles_.push_back({0.0f, 0.0f, width, slot->height, 0});
      put_.push_back(slot);
    }
  }
  layout_.lay_out(tiles_, board);
  for (std::size_t i = 0; i < put_.size(); i++) std::tie(put_[i]->x, put_[i]->y) = std::pair(tiles_[i].x, tiles_[i].y);
}

void Panels::draw_pane(Slot& slot, Desk& desk) {
  if (!slot.moved) ImGui::SetNextWindowPos({slot.x, slot.y});
  const float width = slot.kind->width * scale();
  ImGui::SetNextWindowSizeConstraints({width, 0.0f}, {width, std::max(0.7f * desk.height, 1.0f)});
  if (ImGui::Begin(slot.kind->title, &slot.open,
                   ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav))
    slot.pane->draw(desk);
  slot.x = ImGui::GetWindowPos().x;  // as Dear ImGui rounds it
  slot.y = ImGui::GetWindowPos().y;
  slot.height = ImGui::GetWindowHeight();
  ImGui::End();
}

}  // namespace pantin::player
