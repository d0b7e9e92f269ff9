// What the scene's probes recorded, as plots over time.
#include <imgui.h>

#include "player/panels/pane.hpp"
#include "player/panels/plot.hpp"

namespace pantin::player {
namespace {

class ProbesPane : public Pane {
 public:
  bool useful(const Desk& desk) const override { return !desk.world().probes.empty(); }
  void draw(Desk& desk) override {
    follow(range_, desk.times);
    for (const Probe& probe : desk.world().probes) {
      ImGui::TextUnformatted(probe.name.c_str());
      if (!probe.values.empty()) {
        ImGui::SameLine();
        ImGui::TextDisabled("%.6g", probe.values.back());
      }
      plot(probe, desk.times, range_, 5.5f * ImGui::GetFontSize());
    }
    desk.wishes.save_table |= ImGui::Button("save as .csv");
    ImGui::SameLine();
    if (range_.all)
      ImGui::TextDisabled("wheel: zoom, drag: shift");
    else if (ImGui::Button("show all"))
      range_.all = true;
  }
  void reset() override { range_ = {}; }

 private:
  PlotRange range_;
};

}  // namespace

std::unique_ptr<Pane> make_probes_pane() { return std::make_unique<ProbesPane>(); }

}  // namespace pantin::player
