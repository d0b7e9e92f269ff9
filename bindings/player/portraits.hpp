#pragma once
#include <condition_variable>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <thread>

#include "scene/scene.hpp"
#include "view/renderer.hpp"
#include "view/texture.hpp"

namespace pantin::player {

/// Folder of what may be made again: $XDG_CACHE_HOME/pantin or ~/.cache/pantin; empty where there is neither.
std::string cache_folder();

/// Small pictures of scenes: read from the cache folder, or rendered when they are needed first. A thread of their own
/// opens the scenes and steps them for a moment; they are drawn here. Needs a current context as long as it lives.
class Portraits {
 public:
  static constexpr int width = 384, height = 216;  ///< [px]

  Portraits(SceneOptions options, std::string folder);
  ~Portraits();
  Portraits(const Portraits&) = delete;
  Portraits& operator=(const Portraits&) = delete;

  /// What Dear ImGui calls the picture of a scene's file at a time `at` [s] of its own; null while there is none. The
  /// scenes that are asked for are made, in the order of asking.
  void* picture(const std::string& path, double at);
  /// Why a scene could not be opened or stepped, or empty.
  const std::string& error(const std::string& path);
  /// A part of the work, between two frames: reads a file or draws a picture. `dark`: on a dark ground.
  void work(bool dark);
  /// Forgets what is still to be made, until it is asked for again. Waits for nothing.
  void rest();
  /// Nothing is left to be made.
  bool done() const;

 private:
  /// Of the scene that the thread has in hand. Opened, stepped and dropped by the thread, drawn where it waits.
  enum class State { none, opening, opened, stepping, stepped, failed, dropping };
  struct Entry {
    std::optional<Texture> texture;
    std::string error;                  ///< why it could not be opened or stepped
    double at = 0.0;                    ///< [s] of the scene's time
    bool asked = false, tried = false;  ///< tried: nothing more is to be done
  };

  void run();
  void step(Scene& scene, double until);
  void draw(const std::string& path, bool keep);
  std::string file_of(const std::string& path, double at) const;

  SceneOptions options_;
  std::string folder_;
  std::map<std::string, Entry> entries_;
  std::deque<std::string> queue_;  ///< paths that were asked for and are not in hand
  std::unique_ptr<Renderer> renderer_;
  std::unique_ptr<Camera> camera_;
  bool dark_ = false;

  std::mutex mutex_;
  std::condition_variable changed_;
  State state_ = State::none;
  std::string path_;                        ///< in hand
  double at_ = 0.0;                         ///< the same: time of its picture [s]
  std::unique_ptr<Scene> scene_;            ///< the same
  std::string error_;                       ///< the same
  bool ending_ = false, given_up_ = false;  ///< given up: the scene in hand
  std::thread thread_;
};

}  // namespace pantin::player
