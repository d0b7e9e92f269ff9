#pragma once
#include "world/world.hpp"

namespace pantin::player {

/// Spreads what a frame brought over its steps: the hands that hold something move evenly from where they were, and the
/// commands are for the first step.
class HandPath {
 public:
  /// `frame` is what came in since the last frame; `steps` > 0 will be taken.
  HandPath(const World& world, const StepInput& frame, int steps);
  /// The input of step `i`, from 0.
  StepInput input(int i) const;

 private:
  struct Path {
    HandMove end;
    Vec3 start;  ///< [m]
  };
  std::vector<Path> paths_;
  std::vector<Command> commands_;
  int steps_;
};

/// Keeps the last move of each hand only.
void keep_last_moves(StepInput& input);

}  // namespace pantin::player
