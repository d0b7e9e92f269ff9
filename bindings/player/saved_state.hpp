#pragma once
// States of scenes in files.
#include <memory>
#include <string>

#include "scene/options.hpp"
#include "scene/scene.hpp"

namespace pantin::player {

/// The scene whose state a file holds. `scene`, where it is not empty, is the scene that it must be of. Throws UsageError.
std::unique_ptr<Scene> open_saved(const std::string& file, const std::string& scene, const SceneOptions& options);

/// Writes a state as a whole or leaves the file as it was; an empty name takes one that is free. Returns the file's name.
/// Throws Error.
std::string save_state(Scene& scene, std::string file);

/// What `scene:save(name)` does: a file where the program was started, or below, that ends in .pantin; where there is one, it
/// must be a state. Throws Error.
void save_for_script(const std::string& name, const std::string& state);

}  // namespace pantin::player
