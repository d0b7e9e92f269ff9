// The ledger of energy, line by line.
#include <imgui.h>

#include <cmath>

#include "forces/forces.hpp"
#include "measure/ledger_closure.hpp"
#include "measure/measure.hpp"
#include "player/panels/pane.hpp"

namespace pantin::player {
namespace {

void line(const char* name, double joules) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(name);
  ImGui::TableNextColumn();
  ImGui::Text("%+.6g J", joules);
}

bool begin_lines() {
  if (!ImGui::BeginTable("lines", 2, ImGuiTableFlags_SizingFixedFit)) return false;
  ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthFixed, 11.5f * ImGui::GetFontSize());
  ImGui::TableSetupColumn("joules", ImGuiTableColumnFlags_WidthStretch);
  return true;
}

class LedgerPane : public Pane {
 public:
  void draw(Desk& desk) override {
    const World& world = desk.world();
    if (!(seen_ == desk.seen())) {
      laws_ = law_ledger(world);
      energy_ = energy(world);
      if (world.ledger.kept) truncation_ = truncation(world);
      seen_ = desk.seen();
    }
    if (begin_lines()) {
      line("kinetic", energy_.kinetic);
      line("potential", energy_.potential);
      line("total", energy_.total());
      ImGui::EndTable();
    }
    ImGui::Separator();
    draw_sources(world);
    ImGui::Separator();
    ImGui::Text("energy error %.2g, largest %.2g", world.error.energy, world.worst.energy);
    if (world.ledger.kept)
      ImGui::Text("closure %.2g", closure(world));
    else if (ImGui::Button("keep all lines"))
      keep_ledger(desk.scene.world());
    if (!world.ledger.kept && ImGui::IsItemHovered())
      ImGui::SetTooltip(
          "gravity, projections and integrators too, from now on;\neach law then runs once more in each step");
  }
  void reset() override { seen_ = {}; }

 private:
  void draw_sources(const World& world) {
    if (!begin_lines()) return;
    for (const auto& [name, joules] : laws_.given) line(name.c_str(), joules);
    if (!laws_.without_energy.empty()) line("laws without energy", laws_.open);
    if (world.ledger.kept) line("gravity", world.ledger.gravity);
    bool quiet = true;
    for (std::size_t i = 0; i < source_names.size(); i++) {
      if (!world.ledger.kept && world.ledger.given[i] == 0.0) continue;
      line(source_names[i].data(), world.ledger.given[i]);
      quiet = false;
    }
    if (world.ledger.kept)
      for (const auto& [name, joules] : truncation_) {
        ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
        line(("truncation of " + name).c_str(), joules);
        ImGui::PopStyleColor();
      }
    ImGui::EndTable();
    if (quiet && laws_.given.empty()) ImGui::TextDisabled("nothing from outside so far");
  }

  SeenState seen_;
  LawLedger laws_;
  Energy energy_;
  std::map<std::string, double> truncation_;
};

}  // namespace

std::unique_ptr<Pane> make_ledger_pane() { return std::make_unique<LedgerPane>(); }

}  // namespace pantin::player
