// The choreography: a strip of time with what fired, was dropped and waits, and the same as a list.
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "choreography/choreography.hpp"
#include "player/panels/pane.hpp"
#include "view/keys.hpp"
#include "view/panel_style.hpp"

namespace pantin::player {
namespace {

const char* word(EventState state) {
  switch (state) {
    case EventState::fired: return "fired";
    case EventState::dropped: return "dropped";
    case EventState::cancelled: return "cancelled";
    case EventState::waiting: break;
  }
  return "waits";
}

const char* word(EventKind kind) {
  switch (kind) {
    case EventKind::every: return "every";
    case EventKind::over: return "over";
    case EventKind::when: return "when";
    case EventKind::play: return "play";
    case EventKind::once: break;
  }
  return "at";
}

ImVec4 color_of(EventState state, bool dark) {
  if (state == EventState::fired) return dark ? ImVec4(0.55f, 0.78f, 0.52f, 1.0f) : ImVec4(0.22f, 0.50f, 0.24f, 1.0f);
  if (state == EventState::waiting) return dark ? ImVec4(0.95f, 0.70f, 0.40f, 1.0f) : ImVec4(0.80f, 0.45f, 0.12f, 1.0f);
  return state == EventState::dropped ? warning_ink(dark) : ImGui::GetStyle().Colors[ImGuiCol_TextDisabled];
}

class TimePane : public Pane {
 public:
  void draw(Desk& desk) override {
    const World& world = desk.world();
    if (!(seen_ == desk.seen())) {
      entries_ = timeline(world);
      seen_ = desk.seen();
    }
    ImGui::Text("%.3f s, %llu steps of %.4g ms", world.time, static_cast<unsigned long long>(world.steps),
                1e3 * world.settings.step);
    draw_strip(desk);
    if (entries_.empty())
      ImGui::TextDisabled("nothing was set to happen");
    else
      draw_list(desk);
    if (ImGui::Button(desk.filming ? "end the film" : "film the scene")) desk.wishes.film = true;
    ImGui::SameLine();
    ImGui::TextDisabled("%s: pantin-0001.mp4 and on", key_for(KeyUse::film));
  }
  void reset() override { seen_ = {}; }

 private:
  void draw_strip(const Desk& desk) {
    const float wide = ImGui::GetContentRegionAvail().x, high = 2.6f * ImGui::GetFontSize();
    const ImVec2 from = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton("strip", {wide, high});
    if (ImGui::IsItemHovered() && ImGui::GetIO().MouseWheel != 0.0f)
      span_ = std::clamp(span_ * std::pow(0.8, static_cast<double>(ImGui::GetIO().MouseWheel)), 0.1, 1e4);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const double now = desk.world().time, start = std::max(0.0, now - 0.6 * span_);
    const auto x_of = [&](double time) {
      return from.x + wide * static_cast<float>(std::clamp((time - start) / span_, -1.0, 2.0));
    };
    list.PushClipRect(from, {from.x + wide, from.y + high}, true);
    list.AddRectFilled(from, {from.x + wide, from.y + high}, ImGui::GetColorU32(ImGuiCol_FrameBg), 4.0f);
    draw_scale(list, from, wide, high, start);
    const float top = from.y + 0.2f * high, bottom = from.y + 0.62f * high;
    for (const TimelineEntry& e : entries_) {
      const ImU32 ink = ImGui::GetColorU32(color_of(e.state, desk.dark()));
      if (e.kind == EventKind::over)
        list.AddRectFilled({x_of(e.from), top}, {x_of(e.until), bottom}, (ink & 0xffffffu) | 0x60000000u);
      if (std::isfinite(e.time)) list.AddLine({x_of(e.time), top}, {x_of(e.time), bottom}, ink, 2.0f);
    }
    list.AddLine({x_of(now), from.y}, {x_of(now), from.y + high}, ImGui::GetColorU32(ImGuiCol_Text), 1.5f);
    list.PopClipRect();
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("the wheel shows a longer or shorter time");
  }

  void draw_scale(ImDrawList& list, ImVec2 from, float wide, float high, double start) const {
    double part = std::pow(10.0, std::floor(std::log10(span_ / 4.0)));
    for (const double factor : {2.0, 2.5})
      if (span_ / part > 9.0) part *= factor;
    for (double time = std::ceil(start / part) * part; time < start + span_; time += part) {
      const float x = from.x + wide * static_cast<float>((time - start) / span_);
      char label[24];
      std::snprintf(label, sizeof label, "%.4g", time);
      list.AddLine({x, from.y + 0.75f * high}, {x, from.y + high}, ImGui::GetColorU32(ImGuiCol_TextDisabled));
      list.AddText(nullptr, 0.75f * ImGui::GetFontSize(), {x + 3.0f, from.y + 0.68f * high},
                   ImGui::GetColorU32(ImGuiCol_TextDisabled), label);
    }
  }

  void draw_list(const Desk& desk) {
    const float rows = static_cast<float>(std::min<std::size_t>(entries_.size(), 10)) + 1.3f;
    if (!ImGui::BeginTable("events", 4, ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_ScrollY,
                           {0.0f, rows * ImGui::GetTextLineHeightWithSpacing()}))
      return;
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(entries_.size()));
    while (clipper.Step())
      for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; i++)
        draw_row(entries_[static_cast<std::size_t>(i)], desk);
    ImGui::EndTable();
  }

  static void draw_row(const TimelineEntry& e, const Desk& desk) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    std::isfinite(e.time) ? ImGui::Text("%.3f s", e.time) : ImGui::TextDisabled("when");
    ImGui::TableNextColumn();
    ImGui::TextColored(color_of(e.state, desk.dark()), "%s", word(e.state));
    ImGui::TableNextColumn();
    if (e.kind == EventKind::every)
      ImGui::Text("every %.4g s, %llu times", e.period, static_cast<unsigned long long>(e.fired));
    else if (e.kind == EventKind::over)
      ImGui::Text("over %.4g … %.4g s", e.from, e.until);
    else
      ImGui::TextUnformatted(word(e.kind));
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s %s", e.label.c_str(), e.target.c_str());
  }

  std::vector<TimelineEntry> entries_;
  SeenState seen_;
  double span_ = 10.0;  ///< [s] that the strip shows
};

}  // namespace

std::unique_ptr<Pane> make_time_pane() { return std::make_unique<TimePane>(); }

}  // namespace pantin::player
