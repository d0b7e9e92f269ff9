// What the world logged and the program said; a line that names a living thing chooses it.
#include <imgui.h>

#include <algorithm>

#include "measure/query.hpp"
#include "player/panels/pane.hpp"
#include "view/panel_style.hpp"

namespace pantin::player {
namespace {

/// The first living thing that a text names in quotes: body 'arm'.
AnyId thing_in(const World& world, const std::string& text) {
  for (std::size_t from = text.find('\''); from != text.npos;) {
    const std::size_t to = text.find('\'', from + 1);
    if (to == text.npos) break;
    const AnyId thing = find(world, std::string_view(text).substr(from + 1, to - from - 1));
    if (!std::holds_alternative<std::monostate>(thing)) return thing;
    from = to;
  }
  return {};
}

class LogPane : public Pane {
 public:
  void draw(Desk& desk) override {
    gather(desk.world().log);
    if (lines_.empty() && desk.said.empty()) return ImGui::TextDisabled("nothing was dropped, nothing warned of");
    ImGui::BeginChild("lines", {0.0f, 14.0f * ImGui::GetTextLineHeightWithSpacing()});
    for (const Said& said : desk.said) show(desk, "", said.text, said.times, !said.good);
    for (const Line& line : lines_) {
      char when[32];
      std::snprintf(when, sizeof when, "%.3f s  ", line.time);
      show(desk, when, line.text, line.times, line.kind != "notice");
    }
    if (grew_ && ImGui::GetScrollY() >= ImGui::GetScrollMaxY() - 1.0f) ImGui::SetScrollHereY(1.0f);
    ImGui::EndChild();
  }
  void reset() override { seen_ = 0, lines_.clear(); }

 private:
  struct Line {
    double time;  ///< [s] of the first
    std::string kind, text;
    std::uint64_t times;
  };

  // The same line again, of the latest few, is counted.
  void gather(const std::vector<LogLine>& log) {
    if (log.size() < seen_) reset();
    grew_ = log.size() > seen_;
    for (; seen_ < log.size(); seen_++) {
      const LogLine& line = log[seen_];
      const auto recent = lines_.end() - std::min<std::ptrdiff_t>(std::ssize(lines_), 16);
      const auto same =
          std::find_if(recent, lines_.end(), [&](const Line& l) { return l.kind == line.kind && l.text == line.text; });
      if (same != lines_.end())
        same->times++;
      else
        lines_.push_back({line.time, line.kind, line.text, 1});
      if (lines_.size() > most_lines) lines_.erase(lines_.begin(), lines_.begin() + most_lines / 2);
    }
  }

  static void show(Desk& desk, const char* when, const std::string& text, std::uint64_t times, bool warn) {
    const AnyId thing = thing_in(desk.world(), text);
    const bool linked = !std::holds_alternative<std::monostate>(thing);
    ImGui::PushTextWrapPos(0.0f);
    if (warn) ImGui::PushStyleColor(ImGuiCol_Text, warning_ink(desk.dark()));
    if (times > 1)
      ImGui::TextWrapped("%s%s  (%llu times)", when, text.c_str(), static_cast<unsigned long long>(times));
    else
      ImGui::TextWrapped("%s%s", when, text.c_str());
    if (warn) ImGui::PopStyleColor();
    ImGui::PopTextWrapPos();
    if (!linked) return;
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("click to choose %s", describe(desk.world(), thing).c_str());
    if (ImGui::IsItemClicked()) desk.chosen = thing;
  }

  static constexpr std::size_t most_lines = 2000;
  std::vector<Line> lines_;
  std::size_t seen_ = 0;  ///< lines of the world's log
  bool grew_ = false;
};

}  // namespace

std::unique_ptr<Pane> make_log_pane() { return std::make_unique<LogPane>(); }

}  // namespace pantin::player
