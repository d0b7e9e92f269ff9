#pragma once
#include <chrono>
#include <vector>

#include "measure/measure.hpp"
#include "player/panels/desk.hpp"
#include "view/stage.hpp"
#include "world/world.hpp"

namespace pantin::player {

/// What fell out of a scene: ten of its sizes away, and tied to nothing that is not.
class LostThings {
 public:
  using Clock = std::chrono::steady_clock;

  /// Looks again now and then, where the scene is another.
  void look(const World& world, const Stage& stage, SeenState seen, Clock::time_point now);
  /// Draws a button where there is any, within a frame of Dear ImGui; true where it was pressed. `height` [px].
  bool draw(float height) const;
  /// What puts them above the middle of the scene, beside and over each other.
  std::vector<Command> bring_back(const World& world, const Stage& stage) const;
  void forget() { *this = {}; }

 private:
  std::vector<Things> things_;
  Clock::time_point looked_{};
  SeenState seen_;  ///< when it last looked
};

}  // namespace pantin::player
