#pragma once
#include "world/world.hpp"

namespace pantin::player {

inline constexpr double usual_frame_rate = 60.0;  ///< [1/s]

/// Tells which frames of a film, trajectory or animation are due: `rate` of them in a second of play. Where a script goes
/// back in time, the film goes on.
struct FrameClock {
  double rate = usual_frame_rate;  ///< [1/s]
  double pace = 1.0;               ///< simulated s in a second of play
  std::uint64_t frames = 0;        ///< taken so far
  std::uint64_t steps = 0;         ///< of the world when it was last seen
  double time = 0.0;               ///< [s] the same
  double left_out = 0.0;           ///< [s] of play more than the world's time, by going back

  /// Takes the next frame, if the world has reached it.
  bool take(const World& world) {
    if (world.steps < steps || world.steps > steps + 1) left_out += time - world.time;
    steps = world.steps;
    time = world.time;
    if (static_cast<double>(frames) * pace / rate > left_out + time + 0.5 * world.settings.step) return false;
    frames++;
    return true;
  }
};

}  // namespace pantin::player
