#pragma once
#include <chrono>
#include <memory>
#include <string>

#include "lua/scene.hpp"
#include "player/aim.hpp"
#include "player/options.hpp"
#include "player/pacing.hpp"
#include "player/status.hpp"
#include "player/table.hpp"
#include "view/player_input.hpp"
#include "view/renderer.hpp"
#include "view/window.hpp"

namespace pantin::player {

/// There is a screen, but no window with OpenGL can be opened on it.
struct NoWindow : Error {
  using Error::Error;
};

/// A scene in a window, with hands in it.
class Player {
 public:
  /// Opens the scene and the window; throws what the scene throws, or NoWindow.
  Player(std::string path, const RunOptions& options, const std::string& home);

  /// One frame: input, the steps that are due, a picture. False once it is over.
  bool frame();

  const lua::Scene& scene() const { return *scene_; }
  const Times& times() const { return times_; }
  /// A script's error, or a state that became non-finite, that nobody has restarted from.
  const std::string& failure() const { return failure_; }
  /// The scene as it is now, without the lines and cards.
  void write_picture(const std::string& path);

 private:
  using Clock = std::chrono::steady_clock;

  std::string title() const;
  void act(const Actions& actions);
  void restart();
  void fit_window();
  void take_steps(double elapsed);
  void step_once();
  bool at_end() const;
  void fail(const std::string& why);
  void save_picture();
  Overlay overlay() const;

  std::string path_;
  RunOptions options_;
  lua::SceneOptions lua_options_;
  std::unique_ptr<lua::Scene> scene_;
  Window window_;
  Renderer renderer_;
  Camera camera_;
  Follower follower_;
  PlayerInput hands_;
  Gestures gestures_;
  StepInput waiting_;  ///< what hands did since the last step
  Pacing pacing_;
  Status status_;
  Times times_;
  Clock::time_point last_ = Clock::now();
  bool paused_;
  bool help_ = false;
  bool single_step_ = false;
  std::string failure_;
};

}  // namespace pantin::player
