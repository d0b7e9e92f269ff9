#include "player/status.hpp"

#include <cmath>
#include <cstdio>
#include <string_view>
#include <utility>

namespace pantin::player {
namespace {

/// Parts are written where those of the frame before are, so that nothing is allocated.
class Line {
 public:
  explicit Line(std::vector<std::string>& parts) : parts_(parts) {}
  void print(const char* format, double value) {
    char text[64];
    std::snprintf(text, sizeof text, format, value);
    add(text);
  }
  void add(std::string_view text) {
    if (count_ == parts_.size()) parts_.emplace_back();
    parts_[count_++] = text;
  }
  void end() { parts_.resize(count_); }

 private:
  std::vector<std::string>& parts_;
  std::size_t count_ = 0;
};

/// Of a time [s], with three digits and more where it is long.
const char* three_digits(double time) {
  const double t = std::fabs(time);
  if (t >= 99.95) return "%.0f s";
  if (t >= 9.995) return "%.1f s";
  if (t >= 0.09995 || t == 0.0) return "%.2f s";
  return "%.3g s";
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

void Status::write(const World& world, const Pacing& pacing, const Shown& shown,
                   std::vector<std::string>& parts) const {
  Line line(parts);
  line.print(three_digits(world.time), world.time);
  if (shown.paused)
    line.add("paused");
  else if (pacing.slow_motion())
    line.print("slow motion %.2g×", shown.pace * pacing.speed());
  else
    line.print("speed %.3g×", shown.pace);
  if (shown.solver) {
    line.print("%.0f frames/s", rate_);
    if (world.stats.solves > 0) line.print("Newton %.1f", newton_);
    line.print("energy error %.1e", world.error.energy);
    line.print("largest gap %.1e m", world.error.constraint);
  }
  if (Clock::now() < note_until_) line.add(note_);
  line.end();
}

}  // namespace pantin::player
