// Wall time of each phase of a step, as bars.
#include <imgui.h>

#include <algorithm>
#include <cstdio>

#include "player/panels/pane.hpp"

namespace pantin::player {
namespace {

class PhasesPane : public Pane {
 public:
  void draw(Desk& desk) override {
    measure(desk.world());
    double sum = 0.0, most = 1e-9;
    for (const double ms : ms_) {
      sum += ms;
      most = std::max(most, ms);
    }
    const double rate = desk.world().settings.step / std::max(1e-3 * sum, 1e-12);
    ImGui::Text(rate < 10.0 ? "%.3f ms a step, %.2g s simulated in 1 s" : "%.3f ms a step, %.0f s simulated in 1 s",
                sum, rate);
    if (!ImGui::BeginTable("phases", 2, ImGuiTableFlags_SizingFixedFit)) return;
    for (std::size_t i = 0; i < ms_.size(); i++) {
      ImGui::TableNextRow();
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(phase_names[i].data());
      ImGui::TableNextColumn();
      char label[32];
      std::snprintf(label, sizeof label, "%.3f ms", ms_[i]);
      ImGui::PushStyleColor(ImGuiCol_PlotHistogram, ImGui::GetStyleColorVec4(ImGuiCol_CheckMark));
      ImGui::ProgressBar(static_cast<float>(ms_[i] / most), {9.0f * ImGui::GetFontSize(), 1.1f * ImGui::GetFontSize()},
                         label);
      ImGui::PopStyleColor();
    }
    ImGui::EndTable();
  }
  void reset() override { steps_ = 0; }

 private:
  // Over half a second of the scene's steps or more.
  void measure(const World& world) {
    if (world.steps < steps_ || steps_ == 0) {
      steps_ = world.steps;
      before_ = world.profile.ns;
    }
    if (world.steps < steps_ + 30) return;
    for (std::size_t i = 0; i < ms_.size(); i++)
      ms_[i] = 1e-6 * static_cast<double>(world.profile.ns[i] - before_[i]) / static_cast<double>(world.steps - steps_);
    steps_ = world.steps;
    before_ = world.profile.ns;
  }

  std::uint64_t steps_ = 0;
  std::array<std::int64_t, phase_names.size()> before_{};
  std::array<double, phase_names.size()> ms_{};
};

}  // namespace

std::unique_ptr<Pane> make_phases_pane() { return std::make_unique<PhasesPane>(); }

}  // namespace pantin::player
