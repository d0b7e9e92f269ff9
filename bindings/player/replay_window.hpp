#pragma once
#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "player/aim.hpp"
#include "player/open_window.hpp"
#include "player/pacing.hpp"
#include "player/replay.hpp"
#include "player/status.hpp"
#include "view/fingers.hpp"
#include "view/renderer.hpp"
#include "view/speaker.hpp"

namespace pantin::player {

/// A recording that is played again in a window: one may go to any time of it. Hands do nothing here.
class ReplayWindow {
 public:
  /// Of a file. Throws what read_recording and Replay throw, or NoWindow.
  ReplayWindow(const std::string& recording, const RunOptions& options, const std::string& home);

  /// One frame: input, the steps that are due, a picture. False once it is over.
  bool frame();

  Replay& replay() { return replay_; }
  bool display_lost() const { return window_.lost(); }
  /// Where the recorded script failed, or a state could not be gone to, and nobody has gone elsewhere since.
  const std::string& failure() const { return failure_; }
  bool shows(View view) const { return views_.on(view); }
  /// What a person was told last, while it is shown.
  std::string told() const;

 private:
  using Clock = std::chrono::steady_clock;

  std::string title();
  void take(const PointerEvent& event);
  bool take_key(const std::string& name);
  void tell_of_play(const std::string& name);
  void tell(const std::string& what);
  void run_or_pause();
  void step_back();
  void step_on();
  void change_speed(double factor);
  void advance(double elapsed);
  void seek();
  bool step_once();
  bool at_end();
  void fail(const std::string& why);
  void adopt();
  void look_at_scene();
  std::string message() const;
  Overlay overlay();
  void mark_hands(Overlay& shown);
  void draw_bar();
  void draw_buttons();
  void draw_slider(float width);
  void draw_marks() const;
  void draw_remarks();

  RunOptions options_;
  Window window_;
  Renderer renderer_;
  Replay replay_;
  std::uint64_t openings_;  ///< of the replay's scene, when it was seen last
  std::uint64_t place_;     ///< the same
  Camera camera_;
  Follower follower_;
  Speaker speaker_;
  Gestures gestures_;
  Fingers fingers_;
  Views views_;
  Pacing pacing_;
  Status status_;
  Clock::time_point last_ = Clock::now();
  std::vector<std::uint64_t> marked_;    ///< ticks at which something was done
  std::optional<std::uint64_t> target_;  ///< tick that is being gone to
  bool scrubbing_ = false;               ///< the slider is held
  double speed_ = 1.0;                   ///< times the scene's pace
  bool paused_;
  bool help_ = false;
  std::string failure_;
  std::string told_;
  Clock::time_point told_at_{};
};

}  // namespace pantin::player
