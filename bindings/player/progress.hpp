#pragma once
#include <chrono>

namespace pantin::player {

/// A line on standard error that moves, when that is a terminal and the run takes more than a second.
class Progress {
 public:
  explicit Progress(double until);  ///< [s] simulated
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  void show(double time);  ///< [s] simulated

 private:
  using Clock = std::chrono::steady_clock;
  double until_;
  bool terminal_;
  bool shown_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point next_ = start_ + std::chrono::seconds(1);
};

}  // namespace pantin::player
