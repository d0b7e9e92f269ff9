#include "player/hand_path.hpp"

#include <algorithm>

namespace pantin::player {

HandPath::HandPath(const World& world, const StepInput& frame, int steps) : commands_(frame.commands), steps_(steps) {
  for (const HandMove& move : frame.moves) {
    auto index = static_cast<std::size_t>(move.hand);
    bool holds = index < world.hands.size() && world.hands[index].placed && world.hands[index].grab;
    paths_.push_back({move, holds ? world.hands[index].position : move.position});
  }
}

StepInput HandPath::input(int i) const {
  StepInput input;
  if (i == 0) input.commands = commands_;
  double part = static_cast<double>(i + 1) / steps_;
  for (const Path& path : paths_) {
    HandMove move = path.end;
    if (i + 1 < steps_) move.position = path.start + part * (path.end.position - path.start);
    input.moves.push_back(move);
  }
  return input;
}

void keep_last_moves(StepInput& input) {
  std::size_t kept = 0;
  for (const HandMove& move : input.moves) {
    const auto end = input.moves.begin() + static_cast<std::ptrdiff_t>(kept);
    const auto found = std::find_if(input.moves.begin(), end, [&](const HandMove& m) { return m.hand == move.hand; });
    *found = move;
    kept += found == end;
  }
  input.moves.resize(kept);
}

}  // namespace pantin::player
