#pragma once
// What was built by hand, as a scene of its own.
#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace pantin::player {

struct SavedScene {
  std::string file;
  std::vector<std::string> left_out;  ///< what the file does not have, each by its name and why
};

/// "sandbox-0001.lua" for a script "sandbox.lua" or "sandbox-0003.lua", or the first number of which there is no file in the
/// folder.
std::string free_scene_name(const std::string& script, const std::string& folder);

/// Writes the script with what was made and changed since it ran, as Lua. Before, it opens what it is about to write, to see
/// that it comes to the same; throws Error where it does not open, or cannot be written, and there is no file then.
/// `script` is its path, `source` its text, `options` what the scene was opened with.
SavedScene save_scene(const Scene& scene, const std::string& script, const std::string& source, SceneOptions options,
                      const std::string& file);

}  // namespace pantin::player
