#include "player/status.hpp"

#include <cstdio>
#include <utility>

namespace pantin::player {
namespace {

std::string print(const char* format, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::string speed(const Pacing& pacing, double pace, bool paused) {
  if (paused) return "paused";
  if (pacing.slow_motion()) return print("slow motion %.2g×", pace * pacing.speed());
  return print("speed %.3g×", pace);
}

}  // namespace

void Status::frame(const World& world) {
  frames_++;
  double seconds = std::chrono::duration<double>(Clock::now() - since_).count();
  if (world.stats.solves < solves_) solves_ = iterations_ = 0;  // the scene was opened again
  if (seconds < 0.5) return;
  rate_ = frames_ / seconds;
  if (world.stats.solves > solves_)
    newton_ = static_cast<double>(world.stats.newton_iterations - iterations_) /
              static_cast<double>(world.stats.solves - solves_);
  solves_ = world.stats.solves;
  iterations_ = world.stats.newton_iterations;
  frames_ = 0;
  since_ = Clock::now();
}

void Status::note(std::string text) {
  note_ = std::move(text);
  note_until_ = Clock::now() + std::chrono::seconds(4);
}

std::vector<std::string> Status::parts(const World& world, const Pacing& pacing, double pace, bool paused) const {
  std::vector<std::string> parts = {print("%.2f s", world.time), speed(pacing, pace, paused),
                                    print("%.0f frames/s", rate_)};
  if (world.stats.solves > 0) parts.push_back(print("Newton %.1f", newton_));
  parts.push_back(print("energy error %.1e", world.error.energy));
  parts.push_back(print("largest gap %.1e m", world.error.constraint));
  if (Clock::now() < note_until_) parts.push_back(note_);
  return parts;
}

}  // namespace pantin::player
