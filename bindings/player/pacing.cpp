#include "player/pacing.hpp"

#include <algorithm>
#include <cmath>

namespace pantin::player {

int Pacing::begin_frame(double elapsed, double step, double pace) {
  budget_ = std::clamp(elapsed - spent_, least_budget, largest_budget);
  elapsed = std::clamp(elapsed, 0.0, longest_frame);
  step_ = step;
  double fade = std::exp(-elapsed);
  wanted_ = wanted_ * fade + elapsed * pace;
  reached_ *= fade;
  owed_ += elapsed * pace;

  // The slack takes up the rounding of a sum of frames, so that 60 frames of 1/60 s are 240 steps of 1/240 s.
  double due = std::floor(owed_ / step * (1.0 + 1e-9));
  double affordable = cost_ > 0.0 ? std::max(1.0, std::floor(budget_ / cost_)) : due;
  return static_cast<int>(std::min({due, affordable, 1e6}));
}

void Pacing::end_frame(int done, double seconds) {
  owed_ = std::max(0.0, owed_ - done * step_);
  reached_ += done * step_;
  // Up to a step is carried over; the rest would pile up.
  if (owed_ > step_) owed_ = std::fmod(owed_, step_);
  spent_ = seconds;
  if (done > 0) {
    double cost = seconds / done;
    cost_ = cost_ > 0.0 ? 0.9 * cost_ + 0.1 * cost : cost;
  }
}

}  // namespace pantin::player
