#pragma once
#include <string>
#include <vector>

namespace pantin::player {

/// A scene that can be opened, told without running it.
struct SceneEntry {
  std::string path;
  std::string name;          ///< of the file, without its ending
  std::string title;         ///< from a line `scene.title = "…"`, else the name
  std::string about;         ///< its first comment
  double portrait_at = 2.0;  ///< [s] of its time, at which its small picture is taken
};

/// The scenes in some folders, each in the order of the lines of its file `order.txt`, then of its files' names. A line
/// names a scene, and may say when its picture is taken: "walker 6" at 6 s. A folder that is not there has none; one that
/// was given twice is told once. A .lua file is a scene when it says something of `scene`.
std::vector<SceneEntry> list_scenes(const std::vector<std::string>& folders);

/// Index of the scene at a path, or the number of scenes.
std::size_t find_entry(const std::vector<SceneEntry>& scenes, const std::string& path);

}  // namespace pantin::player
