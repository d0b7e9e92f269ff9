#include "player/saved_state.hpp"

#include <filesystem>
#include <utility>

#include "lua/scene/open.hpp"
#include "player/options.hpp"
#include "player/output.hpp"
#include "scene/errors.hpp"
#include "scene/files.hpp"

namespace pantin::player {
namespace {

void write_whole(const std::string& file, const std::string& state) {
  Output output(file);
  output.write(state);
  output.keep();
}

}  // namespace

std::unique_ptr<Scene> open_saved(const std::string& file, const std::string& scene, const SceneOptions& options) {
  if (!options.set.empty())
    throw UsageError("--set cannot change a saved state: its parameters are those that it was saved with");
  const auto bytes = file_content(file);
  if (!bytes) throw UsageError(text(file, ": there is no such file"));
  std::unique_ptr<Scene> opened = lua::open_state(*bytes, file, options);
  const std::filesystem::path of(scene);
  if (!scene.empty() && of.filename() != opened->file() && of.filename().string() + ".lua" != opened->file())
    throw UsageError(text(file, ": this is a state of ", opened->file(), ", not of ", scene));
  return opened;
}

std::string save_state(Scene& scene, std::string file) {
  if (file.empty()) file = free_name(state_ending);
  write_whole(file, scene.state());
  return file;
}

void save_for_script(const std::string& name, const std::string& state) {
  require(name.ends_with(state_ending) && name.size() > std::string(state_ending).size(), "save: '", name,
          "' must end in ", state_ending);
  require(stays_inside(name) && lies_below(name, "."), "save: '", name,
          "' must be a name like \"state.pantin\" or \"folder/state.pantin\", not an absolute path or one with ..");
  const auto there = file_content(name);
  require(!there || lua::is_state(*there), "save: '", name, "' is a file that is no state; it is left as it is");
  write_whole(name, state);
}

}  // namespace pantin::player
