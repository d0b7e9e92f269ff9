#include "player/home.hpp"

#include <algorithm>
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

std::string shipped_scenes(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    if (entry.path().extension() == ".lua") names.push_back(entry.path().stem());
  std::sort(names.begin(), names.end());
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

std::string find_scene(const std::string& scene, const std::string& home) {
  std::error_code ignored;
  if (fs::is_regular_file(scene, ignored)) return scene;
  fs::path folder = fs::path(home) / "scripts" / "scenes";
  bool plain = !scene.empty() && scene.find('/') == std::string::npos;
  if (fs::path shipped = folder / (scene + ".lua"); plain && fs::is_regular_file(shipped, ignored)) return shipped;
  if (fs::path shipped = folder / scene; plain && fs::is_regular_file(shipped, ignored)) return shipped;
  if (fs::is_directory(scene, ignored)) throw UsageError(text("'", scene, "' is a folder, not a scene"));
  throw UsageError(
      text("there is no scene '", scene, "': give a file, or a shipped scene's name (", shipped_scenes(folder), ")"));
}

std::string scene_name(const std::string& path) { return fs::path(path).stem(); }

}  // namespace pantin::player
