#pragma once
// From a Lua file to a scene.
#include <memory>
#include <set>
#include <string>

#include "scene/scene.hpp"

namespace pantin::lua {

/// Runs the file. Errors of wrong use (no such file, `--set` of an unknown parameter) throw UsageError.
std::unique_ptr<Scene> open_scene(const std::string& path, const SceneOptions& options);
/// The same for a text, called `name` in messages; `require` looks in `folder`.
std::unique_ptr<Scene> open_scene_text(const std::string& source, const std::string& name, const std::string& folder,
                                       const SceneOptions& options);

/// Potentials of the scene whose energy changes with things on which they do not act: "pull (position of a thing)".
std::set<std::string> one_sided_potentials(const World& world);

/// The thread that looks after the limits of scripts is there from here on, where a process may start none later.
void start_limits();

/// Whether a file begins as one of a state.
bool is_state(const std::string& bytes);
/// The scene whose state a file holds; `name` is what messages call the file. What of the state is the program's own
/// (threads, limits, folders) is that of `options`. Throws UsageError where the bytes are no whole state of this version.
std::unique_ptr<Scene> open_state(const std::string& bytes, const std::string& name, const SceneOptions& options);

}  // namespace pantin::lua
