#include "lua/scene/open.hpp"

#include <filesystem>

#include "lua/law/fallback.hpp"
#include "lua/law/recheck.hpp"
#include "lua/scene/heap.hpp"
#include "lua/scene/parameters.hpp"
#include "lua/scene/scene_type.hpp"
#include "lua/scene/script_scene.hpp"
#include "lua/vm/watchdog.hpp"
#include "scene/errors.hpp"
#include "scene/files.hpp"

namespace pantin::lua {

std::unique_ptr<Scene> open_scene(const std::string& path, const SceneOptions& options) {
  const auto source = (options.read ? options.read : file_content)(path, largest_source);
  if (!source) {
    std::error_code error;
    const bool there = std::filesystem::exists(path, error);
    throw UsageError(text(path, ": ", there ? "cannot be read as a file" : "there is no such file"));
  }
  if (options.on_read) options.on_read({path, *source});
  const std::filesystem::path file(path);
  return open_scene_text(*source, file.filename(), file.parent_path(), options);
}

std::unique_ptr<Scene> open_scene_text(const std::string& source, const std::string& name, const std::string& folder,
                                       const SceneOptions& options) {
  const Outside outside;
  auto scene = std::make_unique<ScriptScene>(options);
  Script& script = scene->script();
  script.runtime.name = name;
  script.runtime.folder = folder;
  script.runtime.run([&](lua_State* state) {
    open_globals(state, script);
    note_permanents(state);
  });
  apply_settings(script);
  script.runtime.run([&](lua_State* state) {
    script.runtime.load(state, source, name);
    lua_call(state, 0, 0);
  });
  renew_laws(script.world, script.laws);
  if (options.changing) script.made = made(script.world);
  if (!options.forgiving) check_parameters_known(script);
  return scene;
}

void start_limits() { start_watchdog(); }

std::set<std::string> one_sided_potentials(const World& world) {
  std::set<std::string> names;
  const auto look = [&](const Law& law) {
    const auto* called = dynamic_cast<const CalledLaw*>(law.called.get());
    if (called && law.called_energy && !called->reads.empty())
      names.insert(text(law.name, " (", called->reads, " of a thing)"));
  };
  for (const auto id : world.interactions.ids()) look(*world.interactions[id].law);
  for (const auto id : world.connections.ids()) look(*world.connections[id].law);
  for (const auto id : world.fields.ids()) look(*world.fields[id].law);
  return names;
}

}  // namespace pantin::lua
