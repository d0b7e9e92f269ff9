#pragma once
// From a Lua file to a scene.
#include <memory>
#include <string>

#include "scene/scene.hpp"

namespace pantin::lua {

/// Runs the file. Errors of wrong use (no such file, `--set` of an unknown parameter) throw UsageError.
std::unique_ptr<Scene> open_scene(const std::string& path, const SceneOptions& options);
/// The same for a text, called `name` in messages; `require` looks in `folder`.
std::unique_ptr<Scene> open_scene_text(const std::string& source, const std::string& name, const std::string& folder,
                                       const SceneOptions& options);

}  // namespace pantin::lua
