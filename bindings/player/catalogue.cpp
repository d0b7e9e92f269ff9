#include "player/catalogue.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <utility>

namespace fs = std::filesystem;

namespace pantin::player {
namespace {

std::string trimmed(const std::string& line) {
  const auto from = line.find_first_not_of(" \t\r"), to = line.find_last_not_of(" \t\r");
  return from == line.npos ? "" : line.substr(from, to - from + 1);
}

/// The text between quotes in `scene.title = "…"`, or empty.
std::string title_in(const std::string& line) {
  const std::string start = "scene.title";
  if (!line.starts_with(start)) return {};
  const auto open = line.find_first_of("\"'", start.size());
  if (open == line.npos) return {};
  const auto close = line.find(line[open], open + 1);
  return close == line.npos ? "" : line.substr(open + 1, close - open - 1);
}

/// What a file tells, or an entry without a path where it is no scene.
SceneEntry read_entry(const fs::path& path) {
  SceneEntry entry;
  entry.name = path.stem();
  std::ifstream file(path);
  std::string line;
  bool in_comment = true, is_scene = false;
  while (std::getline(file, line) && line.size() < 4096) {
    if (line.starts_with("\xef\xbb\xbf")) line.erase(0, 3);
    line = trimmed(line);
    if (line.starts_with("#!")) continue;
    in_comment = in_comment && line.starts_with("--");
    if (in_comment)
      entry.about +=
          (entry.about.empty() ? "" : " ") +
          trimmed(line.substr(line.find_first_not_of('-') == line.npos ? line.size() : line.find_first_not_of('-')));
    is_scene |= line.find("scene:") != line.npos || line.find("scene.") != line.npos;
    if (entry.title.empty()) entry.title = title_in(line);
  }
  if (entry.title.empty()) entry.title = entry.name;
  if (is_scene) entry.path = path;
  return entry;
}

/// What a folder's list says of a scene.
struct Listed {
  std::size_t place = 0;  ///< in the list, from 0
  double portrait_at = 2.0;
};

std::map<std::string, Listed> read_order(const fs::path& folder) {
  std::map<std::string, Listed> listed;
  std::ifstream file(folder / "order.txt");
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string name;
    Listed entry{listed.size()};
    if (!(words >> name)) continue;
    if (double at; words >> at && at >= 0.0) entry.portrait_at = at;
    listed.emplace(name, entry);
  }
  return listed;
}

/// A folder's scenes in its order.
std::vector<SceneEntry> scenes_in(const fs::path& folder) {
  const std::map<std::string, Listed> listed = read_order(folder);
  std::vector<SceneEntry> scenes;
  std::error_code failed;
  for (fs::directory_iterator it(folder, failed), end; !failed && it != end; it.increment(failed))
    if (std::error_code unknown; it->path().extension() == ".lua" && it->is_regular_file(unknown))
      if (SceneEntry entry = read_entry(it->path()); !entry.path.empty()) scenes.push_back(std::move(entry));
  const auto place = [&](const SceneEntry& scene) {
    const auto found = listed.find(scene.name);
    return std::pair(found == listed.end() ? listed.size() : found->second.place, scene.path);
  };
  std::ranges::sort(scenes, {}, place);
  for (SceneEntry& scene : scenes)
    if (const auto found = listed.find(scene.name); found != listed.end())
      scene.portrait_at = found->second.portrait_at;
  return scenes;
}

/// Scenes with one title get the name of their file behind it, and where that is the same the folder, too.
void tell_apart(std::vector<SceneEntry>& scenes) {
  std::map<std::string, int> titles, names;
  for (const SceneEntry& scene : scenes) {
    titles[scene.title]++;
    names[scene.title + '\n' + scene.name]++;
  }
  for (SceneEntry& scene : scenes) {
    if (titles[scene.title] < 2) continue;
    const bool same_name = names[scene.title + '\n' + scene.name] > 1;
    const std::string where = same_name ? fs::path(scene.path).parent_path().filename().string() + "/" : "";
    scene.title += " (" + where + scene.name + ")";
  }
}

}  // namespace

std::vector<SceneEntry> list_scenes(const std::vector<std::string>& folders) {
  std::vector<SceneEntry> scenes;
  std::set<fs::path> seen;
  for (const std::string& folder : folders) {
    std::error_code failed;
    const fs::path real = fs::weakly_canonical(folder, failed);
    if (failed || !seen.insert(real).second) continue;
    for (SceneEntry& entry : scenes_in(real)) scenes.push_back(std::move(entry));
  }
  tell_apart(scenes);
  return scenes;
}

std::size_t find_entry(const std::vector<SceneEntry>& scenes, const std::string& path) {
  std::error_code ignored;
  const fs::path real = fs::weakly_canonical(path, ignored);
  const auto found =
      std::find_if(scenes.begin(), scenes.end(), [&](const SceneEntry& s) { return fs::path(s.path) == real; });
  return static_cast<std::size_t>(found - scenes.begin());
}

}  // namespace pantin::player
