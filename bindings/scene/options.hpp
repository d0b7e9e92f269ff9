#pragma once
// What a scene is opened with, and the parameters that it declares.
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "scene/files.hpp"

namespace pantin {

/// Of a parameter or a result.
using SceneValue = std::variant<double, bool, std::string>;

/// What a scene keeps for the next time that it is played: plain values by name.
using SavedValues = std::map<std::string, SceneValue>;

/// A file that a scene read.
struct FileRead {
  std::string path;
  std::string content;
};

/// A scene that another one opens.
struct NextScene {
  std::string path;                              ///< empty: none
  std::map<std::string, SceneValue> parameters;  ///< that it is opened with
  std::string place;                             ///< "scene.lua:12", which asked for it
};

struct SceneOptions {
  std::map<std::string, std::string> set;           ///< `--set`: parameter or `scene.FIELD` to its text
  std::string set_by = "--set ";                    ///< begins what is said of one of `set` that does not fit
  double script_limit = 5.0;                        ///< [s] of one call into the script; 0: none
  std::size_t memory_limit = std::size_t{2} << 30;  ///< [bytes] of the script's memory
  int threads = 1;                                  ///< for the laws; 0: as many as the machine has processors
  std::string home;                                 ///< folder that holds `scripts/lib` and `scripts/behaviours`
  FileReader read;                                  ///< of all files; may be empty: from the disk
  std::function<void(const FileRead&)> on_read;     ///< told each file that is read, even where the scene fails then
  /// Writes a state that the script saves under a name; empty: scripts may not. Throws Error.
  std::function<void(const std::string& name, const std::string& state)> save;
  std::shared_ptr<SavedValues> saved;  ///< `scene.saved`; null: kept in memory as long as the scene
  bool changing = false;               ///< may be followed by the scene of a changed file, see `go_on_from`
  bool forgiving = false;              ///< what `set` says that does not fit the file is left out
};

/// What `scene:param` declared.
struct SceneParameter {
  std::string name;
  SceneValue value;
  SceneValue initial;
  std::optional<double> min, max, step;
  std::vector<SceneValue> choices;
  std::string help;
  bool live = false;     ///< has `on_change`; else a change rebuilds the scene
  bool integer = false;  ///< its default is a whole number without a point
};

}  // namespace pantin
