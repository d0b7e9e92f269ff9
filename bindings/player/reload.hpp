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
  /// Opens a scene; its files are watched from then on, even where this throws.
  std::unique_ptr<Scene> open(const std::string& path, SceneOptions options);
  /// Whether a file was saved, and what came of that.
  std::optional<Reloaded> look(Scene& playing, const std::string& path, const SceneOptions& options,
                               FileWatch::Clock::time_point now = FileWatch::Clock::now());
  /// Files that the scene opened last read so far, with their contents.
  const std::map<std::string, std::string>& files() const { return *files_; }

  /// Told each file that is read from now on; may be empty.
  std::function<void(const FileRead&)> on_read;

 private:
  using Files = std::map<std::string, std::string>;
  FileWatch watch_;
  std::shared_ptr<Files> files_ = std::make_shared<Files>();
};

/// What hands did for the old scene, for the new one: what concerns things that are gone is left out.
StepInput carried_over(const StepInput& input, const CarriedOver& carried);

}  // namespace pantin::player
