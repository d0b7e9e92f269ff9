#pragma once
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "player/file_watch.hpp"
#include "scene/scene.hpp"
#include "world/input.hpp"

namespace pantin::player {

/// What came of saving a file: a scene that goes on where the old one is, or why there is none.
struct Reloaded {
  std::unique_ptr<Scene> scene;
  CarriedOver carried;
  std::string error;
};

/// Opens scenes, and opens them again when a file that they read was saved.
class Reload {
 public:
  using Files = std::map<std::string, std::string>;
  using Read = std::shared_ptr<const Files>;

  /// Opens a scene; its files are watched from then on, even where this throws. But for the first, and one that is opened
  /// `anew`, what `set` says was for the file as it was: what does not fit any more is left out.
  std::unique_ptr<Scene> open(const std::string& path, SceneOptions options, bool anew = false);
  /// Whether a file was saved, and what came of that.
  std::optional<Reloaded> look(Scene& playing, const std::string& path, const SceneOptions& options,
                               FileWatch::Clock::time_point now = FileWatch::Clock::now());
  /// Files that the scene opened last read so far, with their contents.
  const Files& files() const { return *files_; }
  /// The same, also after another scene was opened.
  Read read() const { return files_; }
  /// A scene that was opened before another is played again: it was opened last, with its files as they are now.
  void go_back_to(const Read& read);

  /// Told each file that is read from now on; may be empty.
  std::function<void(const FileRead&)> on_read;

 private:
  FileWatch watch_;
  Read files_ = std::make_shared<Files>();
};

/// What hands did for the old scene, for the new one: what concerns things that are gone is left out.
StepInput carried_over(const StepInput& input, const CarriedOver& carried);

}  // namespace pantin::player
