#include "player/browser.hpp"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cctype>
#include <cfloat>
#include <filesystem>
#include <sstream>
#include <string_view>
#include <utility>

namespace pantin::player {
namespace {

constexpr ImGuiWindowFlags whole_window =
    ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav;
constexpr float card_width = 290.0f;  // [px] at scale 1, at least

float scale() { return ImGui::GetFontSize() / 14.0f; }

bool pressed(ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key)); }

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
  return text;
}

/// Why a scene has no picture, in the picture's place.
void draw_error(const std::string& error, ImVec2 from, ImVec2 to) {
  const float pad = 10.0f * scale();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(from, to, true);
  list.AddText(nullptr, 0.9f * ImGui::GetFontSize(), {from.x + pad, from.y + pad},
               ImGui::GetColorU32(ImGuiCol_TextDisabled), error.c_str(), nullptr, to.x - from.x - 2.0f * pad);
  list.PopClipRect();
}

void big_text(const char* text, float size) {
  ImGui::SetWindowFontScale(size);
  ImGui::TextUnformatted(text);
  ImGui::SetWindowFontScale(1.0f);
}

/// Up to so many lines of a text, wrapped between words; an ellipsis tells that there is more.
void draw_lines(const std::string& text, ImVec2 at, float width, int lines, float size, ImGuiCol color) {
  const ImFont& font = *ImGui::GetFont();
  const char* const more = font.FindGlyphNoFallback(0x2026) ? "\u2026" : "...";
  const char *from = text.data(), *const end = from + text.size();
  for (int i = 1; i <= lines && from < end; i++) {
    const char* to = font.CalcWordWrapPositionA(size / font.FontSize, from, end, width);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (i == lines && to < end) {
      const float room = width - font.CalcTextSizeA(size, FLT_MAX, 0.0f, more).x;
      to = font.CalcWordWrapPositionA(size / font.FontSize, from, end, room);
      const float wide = font.CalcTextSizeA(size, FLT_MAX, 0.0f, from, to).x;
      list.AddText(nullptr, size, {at.x + wide, at.y}, ImGui::GetColorU32(color), more);
    }
    list.AddText(nullptr, size, at, ImGui::GetColorU32(color), from, to);
    at.y += size;
    for (from = to; from < end && (*from == ' ' || *from == '\n'); from++) {}
  }
}

}  // namespace

Browser::Browser(const std::string& shipped, std::string games, std::string own, SceneOptions options)
    : shipped_(std::filesystem::weakly_canonical(shipped)),
      games_(std::move(games)),
      own_(std::move(own)),
      options_(std::move(options)) {}

void Browser::show() {
  shown_ = appearing_ = true;
  search_.clear();
  list();
  if (!portraits_) portraits_ = std::make_unique<Portraits>(options_, cache_folder());
}

void Browser::hide() {
  shown_ = false;
  if (portraits_) portraits_->rest();
}

std::string Browser::neighbour(const std::string& path, int places) {
  list();
  if (scenes_.empty()) return {};
  const auto count = static_cast<int>(scenes_.size());
  const auto at = static_cast<int>(find_entry(scenes_, path));
  // From a scene that is not among them, the next is the first.
  const int from = at < count ? at : places > 0 ? -1 : 0;
  return scenes_[static_cast<std::size_t>((from + places + count) % count)].path;
}

void Browser::list() {
  scenes_ = list_scenes({shipped_, games_, own_});
  listed_ = true;
}

void Browser::work(bool dark) {
  if (portraits_) portraits_->work(dark);
}

bool Browser::found(const SceneEntry& scene) const {
  const std::string all = lower(scene.title + " " + scene.name + " " + scene.about);
  std::istringstream words(lower(search_));
  for (std::string word; words >> word;)
    if (all.find(word) == all.npos) return false;
  return true;
}

/// What is called so comes first, then what has a word that begins so.
int Browser::rank(const SceneEntry& scene) const {
  const std::string sought = lower(search_), name = lower(scene.name), title = lower(scene.title);
  if (name.starts_with(sought) || title.starts_with(sought)) return 0;
  const std::string all = " " + title + " " + name + " " + lower(scene.about);
  return all.find(" " + sought) != all.npos ? 1 : 2;
}

void Browser::draw(const std::string& open, float width, float height) {
  chosen_.clear();
  left_ = false;
  ImGui::SetNextWindowPos({0.0f, 0.0f});
  ImGui::SetNextWindowSize({width, height});
  ImGui::SetNextWindowBgAlpha(1.0f);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0f);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {26.0f * scale(), 20.0f * scale()});
  ImGui::Begin("scenes", nullptr, whole_window);
  ImGui::PopStyleVar(2);
  draw_head(width);
  if (search_ != searched_ || std::exchange(listed_, false)) search();
  draw_cards(open);
  ImGui::End();
}

void Browser::search() {
  shown_scenes_.clear();
  for (std::size_t i = 0; i < scenes_.size(); i++)
    if (found(scenes_[i])) shown_scenes_.push_back(i);
  if (!search_.empty()) std::ranges::stable_sort(shown_scenes_, {}, [&](std::size_t i) { return rank(scenes_[i]); });
  if (search_ != searched_) mark_ = 0;
  searched_ = search_;
}

void Browser::draw_head(float width) {
  big_text("Pantin", 1.7f);
  ImGui::SameLine(0.0f, 24.0f * scale());
  ImGui::SetCursorPosY(ImGui::GetCursorPosY() + 3.0f * scale());
  ImGui::SetNextItemWidth(std::min(320.0f * scale(), 0.5f * width));
  const bool appears = std::exchange(appearing_, false);
  if (appears) ImGui::SetKeyboardFocusHere();
  const bool was_empty = search_.empty();
  ImGui::InputTextWithHint("##search", "search", &search_,
                           ImGuiInputTextFlags_AutoSelectAll);  // a new word replaces it
  if (!appears && pressed(ImGuiKey_Escape)) {                   // the Esc that led here is none to leave by
    left_ = was_empty;
    search_.clear();
    appearing_ = true;  // the field wants the keys again
  }
  ImGui::SameLine(0.0f, 16.0f * scale());
  if (search_.empty())
    ImGui::TextDisabled("%zu scenes. Click one, or type and press Enter", scenes_.size());
  else
    ImGui::TextDisabled("%zu of %zu scenes (Esc: all)", shown_scenes_.size(), scenes_.size());
  ImGui::Spacing();
}

void Browser::move_mark(int columns) {
  const auto count = static_cast<int>(shown_scenes_.size());
  const int by = pressed(ImGuiKey_DownArrow)                       ? columns
                 : pressed(ImGuiKey_UpArrow)                       ? -columns
                 : search_.empty() && pressed(ImGuiKey_RightArrow) ? 1
                 : search_.empty() && pressed(ImGuiKey_LeftArrow)  ? -1
                                                                   : 0;
  const int to = static_cast<int>(mark_) + by;
  moved_ = by != 0 && to >= 0 && to < count;
  if (moved_) mark_ = static_cast<std::size_t>(to);
  if (mark_ >= shown_scenes_.size()) mark_ = 0;
  if (count > 0 && (pressed(ImGuiKey_Enter) || pressed(ImGuiKey_KeyPadEnter)))
    chosen_ = scenes_[shown_scenes_[mark_]].path;
}

void Browser::draw_cards(const std::string& open) {
  ImGui::BeginChild("cards", {0.0f, 0.0f}, false, ImGuiWindowFlags_NoNav);
  const float between = 14.0f * scale(), wide = ImGui::GetContentRegionAvail().x;
  const int columns = std::max(1, static_cast<int>((wide + between) / (card_width * scale() + between)));
  const float width = (wide - between * static_cast<float>(columns - 1)) / static_cast<float>(columns);
  move_mark(columns);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {between, between});
  std::string_view folder = shipped_;
  int column = 0;
  for (std::size_t i = 0; i < shown_scenes_.size(); i++) {
    const SceneEntry& scene = scenes_[shown_scenes_[i]];
    const std::string_view here = std::string_view(scene.path).substr(0, scene.path.rfind('/'));
    if (search_.empty() && here != folder) {
      folder = here;
      column = 0;
      ImGui::Spacing();
      ImGui::TextDisabled("%.*s", static_cast<int>(here.size()), here.data());
    }
    if (column > 0) ImGui::SameLine();
    column = (column + 1) % columns;
    if (draw_card(scene, width, i == mark_ && (!search_.empty() || moved_ || mark_ > 0), scene.path == open))
      chosen_ = scene.path;
    if (i == mark_ && moved_) ImGui::SetScrollHereY();
  }
  if (shown_scenes_.empty()) ImGui::TextDisabled("no scene says this");
  ImGui::PopStyleVar();
  ImGui::EndChild();
}

bool Browser::draw_card(const SceneEntry& scene, float width, bool lit, bool is_nonconservative) {
  const float pad = 10.0f * scale(), line = ImGui::GetTextLineHeight(), round = 8.0f * scale();
  const float picture = width * Portraits::height / Portraits::width, height = picture + 3.6f * line + 1.6f * pad;
  ImGui::PushID(scene.path.c_str());
  const bool clicked = ImGui::InvisibleButton("card", {width, height});
  const bool hovered = ImGui::IsItemHovered();
  ImGui::PopID();
  const ImVec2 from = ImGui::GetItemRectMin(), to = ImGui::GetItemRectMax();
  if (!ImGui::IsItemVisible()) return clicked;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(
      from, to, ImGui::GetColorU32(hovered ? ImGuiCol_ButtonHovered : ImGuiCol_FrameBg, hovered ? 1.0f : 0.55f), round);
  if (void* texture = portraits_ ? portraits_->picture(scene.path, scene.portrait_at) : nullptr)
    list.AddImageRounded(texture, from, {to.x, from.y + picture}, {0, 0}, {1, 1}, IM_COL32_WHITE, round,
                         ImDrawFlags_RoundCornersTop);
  else if (portraits_)
    draw_error(portraits_->error(scene.path), from, {to.x, from.y + picture});
  if (lit || is_nonconservative)
    list.AddRect(from, to, ImGui::GetColorU32(ImGuiCol_CheckMark), round, 0, (lit ? 3.0f : 1.5f) * scale());
  const ImVec2 at = {from.x + pad, from.y + picture + 0.6f * pad};
  const float wrap = width - 2.0f * pad;
  draw_lines(scene.title, at, wrap, 1, ImGui::GetFontSize(), ImGuiCol_Text);
  draw_lines(scene.about, {at.x, at.y + 1.25f * line}, wrap, 3, 0.9f * ImGui::GetFontSize(), ImGuiCol_TextDisabled);
  if (hovered && !scene.about.empty()) {
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(26.0f * ImGui::GetFontSize());
    ImGui::TextUnformatted(scene.about.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
  }
  return clicked;
}

}  // namespace pantin::player
