#pragma once
#include <chrono>
#include <string>
#include <vector>

#include "player/pacing.hpp"
#include "world/world.hpp"

namespace pantin::player {

/// The quiet line at the bottom of the window.
class Status {
 public:
  using Clock = std::chrono::steady_clock;

  /// A frame was drawn.
  void frame(const World& world);
  /// Shows a note for a few seconds.
  void note(std::string text);
  struct Shown {
    double pace = 1.0;  ///< simulated s per real s
    bool paused = false;
    bool solver = false;  ///< frames a second, iterations and errors, too
  };
  /// Writes the parts of the line over those of the frame before.
  void write(const World& world, const Pacing& pacing, const Shown& shown, std::vector<std::string>& parts) const;

 private:
  Clock::time_point since_ = Clock::now();  ///< start of the present half second
  int frames_ = 0;                          ///< in it
  double rate_ = 0.0;                       ///< [1/s] frames
  std::uint64_t solves_ = 0;                ///< at its start
  std::uint64_t iterations_ = 0;            ///< at its start
  double newton_ = 0.0;                     ///< iterations of an articulate per step
  std::string note_;
  Clock::time_point note_until_{};
};

}  // namespace pantin::player
