// What the solver does: articulates, unknowns, iterations, fallbacks; and what touches.
#include <imgui.h>

#include <algorithm>

#include "articulates/articulate.hpp"
#include "measure/measure.hpp"
#include "player/panels/pane.hpp"
#include "view/panel_style.hpp"

namespace pantin::player {
namespace {

using Count = unsigned long long;

void count_line(const char* name, Count count, bool warn = false) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(name);
  ImGui::TableNextColumn();
  if (warn && count > 0) ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_CheckMark));
  ImGui::Text("%llu", count);
  if (warn && count > 0) ImGui::PopStyleColor();
}

class SolverPane : public Pane {
 public:
  void draw(Desk& desk) override {
    const World& world = desk.world();
    if (desk.world().steps < since_.steps) since_ = {};
    if (world.steps >= since_.steps + 30) {
      if (world.stats.solves > since_.solves)
        newton_ = static_cast<double>(world.stats.newton_iterations - since_.iterations) /
                  static_cast<double>(world.stats.solves - since_.solves);
      contact_iterations_ = static_cast<double>(world.stats.contact_iterations - since_.contact_iterations) /
                            static_cast<double>(world.steps - since_.steps);
      since_ = {world.steps, world.stats.solves, world.stats.newton_iterations, world.stats.contact_iterations};
    }
    Count unknowns = 0;
    for (const auto& articulate : world.articulates) unknowns += 3 * articulate->rows.size();
    if (ImGui::BeginTable("counts", 2, ImGuiTableFlags_SizingStretchProp)) {
      count_line("articulates", world.articulates.size());
      count_line("unknown forces", unknowns);
      count_line("loose bodies", world.loose_bodies.size());
      count_line("loose points", world.loose_points.size());
      count_line("factorisations", world.stats.factorisations);
      count_line("most iterations", world.stats.worst_iterations);
      count_line("halved steps", world.stats.halved_steps, true);
      count_line("fallback steps", world.stats.fallback_steps, true);
      count_line("accuracy not reached", world.stats.unreached, true);
      ImGui::EndTable();
    }
    ImGui::Text("%.2f iterations of Newton a solve, lately", newton_);
    ImGui::Text("hinge gap %.2g m, constraints %.2g m", world.error.hinge_gap, world.error.constraint);
    if (!world.shapes.empty()) draw_contacts(world);
    if (world.settings.accuracy || world.sub_steps.count > 1) draw_sub_steps(world);
    draw_articulates(world);
  }

 private:
  struct Since {
    std::uint64_t steps = 0, solves = 0, iterations = 0, contact_iterations = 0;
  };

  void draw_contacts(const World& world) const {
    ImGui::Separator();
    const Stats& s = world.stats;
    if (ImGui::BeginTable("contacts", 2, ImGuiTableFlags_SizingStretchProp)) {
      count_line("contacts", s.contacts);
      count_line("islands of contacts", s.contact_islands);
      count_line("unsolved islands", s.unsolved_islands, true);
      ImGui::EndTable();
    }
    ImGui::Text("%.2f iterations a step, lately", contact_iterations_);
    ImGui::Text("overlap %.2g m, pushed out %.3g J", world.error.penetration,
                world.ledger.given[static_cast<std::size_t>(Source::push_out)]);
    ImGui::Text("friction and impact %+.4g J", world.ledger.given[static_cast<std::size_t>(Source::contact)]);
    ImGui::Text("energy error %.2g", world.error.energy);
  }

  static void draw_sub_steps(const World& world) {
    const MostSubSteps most = most_sub_steps(world);
    ImGui::Text("sub-steps %u, most %u %s", world.sub_steps.count, most.count, most.thing.c_str());
  }

  void draw_articulates(const World& world) {
    if (world.articulates.empty() || !ImGui::TreeNode("biggest articulates")) return;
    biggest_.clear();
    for (const auto& articulate : world.articulates) biggest_.push_back(articulate.get());
    const std::size_t shown = std::min<std::size_t>(biggest_.size(), 8);
    std::partial_sort(biggest_.begin(), biggest_.begin() + static_cast<std::ptrdiff_t>(shown), biggest_.end(),
                      [](const Articulate* a, const Articulate* b) { return a->rows.size() > b->rows.size(); });
    for (std::size_t i = 0; i < shown; i++) {
      const Articulate& a = *biggest_[i];
      ImGui::Text("%zu things, %zu rows, gap %.1g m%s%s", a.nodes.size(), a.rows.size(), a.gaps.all(),
                  a.loop_free ? ", no loops" : "", a.fell_back ? ", fallback step" : "");
    }
    ImGui::TreePop();
  }

  Since since_;
  double newton_ = 0.0, contact_iterations_ = 0.0;
  std::vector<const Articulate*> biggest_;
};

}  // namespace

std::unique_ptr<Pane> make_solver_pane() { return std::make_unique<SolverPane>(); }

}  // namespace pantin::player
