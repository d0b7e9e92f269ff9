#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "base/lanes.hpp"
#include "model/particle.hpp"
#include "model/point.hpp"

namespace pantin {

/// Where a hand is at the end of the coming step.
struct HandMove {
  std::int32_t hand = 0;
  Vec3 position = zero3();  ///< [m]
  bool pressed = false;
};

/// What a person did before a step, besides moving.
struct Command {
  enum class Kind : std::uint8_t { grab, release, cut, key, button };
  Kind kind = Kind::key;
  std::int32_t hand = 0;
  PointId point;           ///< grab
  double max_force = 0.0;  ///< [N] grab; 0 takes `usual_grab_force`
  ParticleId hinge;        ///< cut
  std::string name;        ///< key or button
};

/// All that the outside told the world for one step; plain data, so that play can be replayed.
struct StepInput {
  std::vector<HandMove> moves;
  std::vector<Command> commands;
};

}  // namespace pantin
