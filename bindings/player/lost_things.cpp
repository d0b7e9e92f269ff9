#include "player/lost_things.hpp"

#include <imgui.h>

#include <algorithm>

#include "choreography/bring_back.hpp"
#include "view/panel_style.hpp"

namespace pantin::player {

namespace {

constexpr std::size_t most = 100, in_a_row = 5;
constexpr std::chrono::milliseconds between_looks{500};

Vec3 middle_of(const Stage& stage) { return 0.5 * (stage.lower + stage.upper); }

}  // namespace

void LostThings::look(const World& world, const Stage& stage, SeenState seen, Clock::time_point now) {
  if (now < looked_ + between_looks || seen == seen_) return;
  looked_ = now;
  seen_ = seen;
  things_.clear();
  if (!stage.empty && !world.settings.box) things_ = fallen_out(world, middle_of(stage), far_away * stage.size, most);
}

bool LostThings::draw(float height) const {
  if (things_.empty()) return false;
  const float scale = ImGui::GetFontSize() / 14.0f;
  ImGui::SetNextWindowPos({10.0f * scale, height - 40.0f * scale}, ImGuiCond_Always, {0.0f, 1.0f});
  ImGui::Begin("lost", nullptr, quiet_window);
  ImGui::AlignTextToFramePadding();
  ImGui::Text(things_.size() == 1 ? "%zu thing fell out" : "%zu things fell out", things_.size());
  ImGui::SameLine();
  const bool pressed = ImGui::Button(things_.size() == 1 ? "bring it back" : "bring them back");
  ImGui::End();
  return pressed;
}

std::vector<Command> LostThings::bring_back(const World& world, const Stage& stage) const {
  std::vector<Command> commands;
  double apart = 0.0;
  for (const Things& things : things_) {
    const Bounds box = bounds(world, things);
    apart = std::max(apart, norm(box.high - box.low));
  }
  apart = std::max(1.2 * apart, 0.05 * stage.size);
  const Vec3 middle = middle_of(stage);
  for (std::size_t i = 0; i < things_.size(); i++) {
    const std::size_t column = i % in_a_row, row = i / in_a_row;
    const double side = column % 2 == 1 ? 0.5 * static_cast<double>(column + 1) : -0.5 * static_cast<double>(column);
    Command& c = commands.emplace_back();
    c.kind = Command::Kind::bring;
    if (things_[i].bodies.empty())
      c.point = things_[i].free_points[0];
    else
      c.thing = things_[i].bodies[0];
    c.position = vec(middle[0] + apart * side, stage.upper[1] + apart * (0.5 + static_cast<double>(row)), middle[2]);
  }
  return commands;
}

}  // namespace pantin::player
