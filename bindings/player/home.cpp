#include "player/home.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <vector>

#include "scene/errors.hpp"

namespace fs = std::filesystem;

namespace pantin::player {
namespace {

bool holds_scenes(const fs::path& folder) {
  std::error_code ignored;
  return fs::is_directory(folder / "scripts" / "scenes", ignored);
}

/// Games are scenes, too.
std::array<fs::path, 2> shipped_folders(const fs::path& home) {
  return {home / "scripts" / "scenes", home / "examples" / "games"};
}

std::string listed(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return list;
}

}  // namespace

std::string find_home() {
  if (const char* given = std::getenv("PANTIN_HOME"); given && *given) {
    require(holds_scenes(given), "PANTIN_HOME=", given, " holds no folder scripts/scenes");
    return fs::absolute(given);
  }
  std::error_code failed;
  fs::path program = fs::read_symlink("/proc/self/exe", failed);
  for (fs::path folder = program.parent_path(); !failed && !folder.empty(); folder = folder.parent_path()) {
    if (holds_scenes(folder)) return folder;
    if (holds_scenes(folder / "share" / "pantin")) return folder / "share" / "pantin";
    if (folder == folder.parent_path()) break;
  }
  throw Error(
      "the folder scripts/scenes was found neither above the program nor in share/pantin; set PANTIN_HOME to the "
      "folder that holds scripts");
}

std::vector<std::string> shipped_names(const std::string& home) {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const fs::path& folder : shipped_folders(home))
    for (const auto& entry : fs::directory_iterator(folder, ignored))
      if (entry.path().extension() == ".lua") names.push_back(entry.path().stem());
  std::sort(names.begin(), names.end());
  return names;
}

std::string find_scene(const std::string& scene, const std::string& home) {
  std::error_code ignored;
  if (fs::is_regular_file(scene, ignored)) return scene;
  if (!scene.empty() && scene.find('/') == std::string::npos)
    for (const fs::path& folder : shipped_folders(home))
      for (const fs::path& shipped : {folder / (scene + ".lua"), folder / scene})
        if (fs::is_regular_file(shipped, ignored)) return shipped;
  if (fs::is_directory(scene, ignored)) throw UsageError(text("'", scene, "' is a folder, not a scene"));
  throw UsageError(text("there is no scene '", scene, "': give a file, or a shipped scene's name (",
                        listed(shipped_names(home)), ")"));
}

std::string scene_name(const std::string& path) { return fs::path(path).stem(); }

}  // namespace pantin::player
