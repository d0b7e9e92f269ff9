#pragma once
#include <string>
#include <vector>

namespace pantin::player {

/// Folder that holds `scripts` and `assets`: PANTIN_HOME, else the nearest one above the program, else the installed
/// share/pantin. Throws Error where there is none.
std::string find_home();

/// Names of the scenes and games in there, sorted.
std::vector<std::string> shipped_names(const std::string& home);

/// A path as it is given, or a shipped scene's by its name: "chain". Throws UsageError that names the shipped ones.
std::string find_scene(const std::string& scene, const std::string& home);

/// "scenes/chain.lua" is called "chain": outputs are named after it.
std::string scene_name(const std::string& path);

}  // namespace pantin::player
