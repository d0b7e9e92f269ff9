#pragma once
// A game for two: each pushes a ball among boxes. It moves by inputs alone, so the same inputs give the same bits.
#include <array>
#include <cstdint>

#include "world/world.hpp"

namespace rollback {

/// What a player holds down in a frame: bits of left, right, forth, back.
using Input = std::uint8_t;
using Inputs = std::array<Input, 2>;  ///< (players)

class Game {
 public:
  Game();
  /// One frame of 1/60 s.
  void play(const Inputs& inputs);
  pantin::World& world() { return world_; }

 private:
  pantin::World world_;
  std::array<pantin::BodyId, 2> balls_;
};

/// What a player does in a frame, in place of a person: a whim, held for some frames.
Input whim(int player, std::uint32_t frame);

}  // namespace rollback
