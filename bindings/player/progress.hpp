#pragma once
// How far a long run is, on standard error.
#include <chrono>
#include <string>

namespace pantin::player {

/// On a terminal a line that moves; elsewhere, as in a log of Slurm, lines now and then: each tenth of the way or each five
/// minutes, but none within ten seconds.
class ProgressLine {
 public:
  using Clock = std::chrono::steady_clock;

  /// `quiet`: how long a terminal stays without.
  explicit ProgressLine(Clock::duration quiet = {});
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  bool moves() const { return terminal_; }
  /// Whether a line is to be shown when `part` in [0, 1] of the way is done.
  bool is_due(double part) const;
  void show(double part, const std::string& line);
  double seconds() const;  ///< since it was made
  /// "35 s left", from how long what was done since took; `done` in (0, 1] of it.
  std::string time_left(double done) const;

 private:
  bool terminal_, shown_ = false;
  Clock::time_point start_ = Clock::now(), last_ = start_, next_;
  double part_ = 0.0;  // that was shown last
};

/// Of what is simulated.
class Progress {
 public:
  explicit Progress(double from);        ///< [s] simulated
  void show(double time, double until);  ///< [s] simulated

 private:
  double from_;
  ProgressLine line_{std::chrono::seconds(1)};
};

}  // namespace pantin::player
