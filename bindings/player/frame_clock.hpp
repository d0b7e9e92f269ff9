#pragma once
#include "world/world.hpp"

namespace pantin::player {

inline constexpr double usual_frame_rate = 60.0;  ///< [1/s]

/// Tells which frames of a film, trajectory or animation are due: `rate` of them in a second of play.
struct FrameClock {
  double rate = usual_frame_rate;  ///< [1/s]
  double pace = 1.0;               ///< simulated s in a second of play
  std::uint64_t frames = 0;        ///< taken so far

  /// Takes the next frame, if the world has reached it.
  bool take(const World& world) {
    if (static_cast<double>(frames) * pace / rate > world.time + 0.5 * world.settings.step) return false;
    frames++;
    return true;
  }
};

}  // namespace pantin::player
