#pragma once

namespace pantin::player {

/// Turns wall time into fixed steps. What cannot be done within a frame's share of wall time is dropped, never saved up: a
/// scene that is too slow runs in slow motion.
class Pacing {
 public:
  /// [s] Steps of one frame may take as much wall time as all else in it, within these bounds.
  static constexpr double least_budget = 0.025, largest_budget = 0.1;
  static constexpr double longest_frame = 0.25;  ///< [s] a frame that took longer counts as this long

  /// Steps to take in a frame that begins `elapsed` [s] of wall time after the last one, for steps of `step` [s] at
  /// `pace` simulated seconds per real second.
  int begin_frame(double elapsed, double step, double pace);
  /// Whether steps that took `seconds` of wall time so far in this frame leave time for another.
  bool has_time(double seconds) const { return seconds < budget_; }
  /// `done` steps were taken, in `seconds` of wall time.
  void end_frame(int done, double seconds);
  /// Forgets what was owed: after a pause.
  void rest() { owed_ = 0.0; }

  /// Simulated time reached over simulated time wanted, over the last second or so: 1 at full speed.
  double speed() const { return wanted_ > 0.0 ? reached_ / wanted_ : 1.0; }
  bool slow_motion() const { return speed() < 0.95; }

 private:
  double step_ = 0.0;             ///< [s]
  double owed_ = 0.0;             ///< [s] simulated, not yet taken
  double wanted_ = 0.0;           ///< [s] simulated, of the last second, fading
  double reached_ = 0.0;          ///< [s] the same, reached
  double budget_ = least_budget;  ///< [s] wall time for the steps of this frame
  double spent_ = 0.0;            ///< [s] wall time that the last frame's steps took
  double cost_ = 0.0;             ///< [s] wall time of a step, running mean
};

}  // namespace pantin::player
