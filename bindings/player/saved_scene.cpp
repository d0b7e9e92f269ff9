#include "player/saved_scene.hpp"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <filesystem>

#include "lua/scene/open.hpp"
#include "measure/measure.hpp"
#include "player/lua_of_things.hpp"
#include "player/output.hpp"
#include "scene/files.hpp"

namespace fs = std::filesystem;

namespace pantin::player {
namespace {

/// Without the number that `free_scene_name` gave it.
std::string plain_stem(const std::string& script) {
  std::string stem = fs::path(script).stem().string();
  const std::size_t end = stem.size() < 5 ? 0 : stem.size() - 5;
  const bool numbered = end > 0 && stem[end] == '-' &&
                        std::all_of(stem.begin() + static_cast<std::ptrdiff_t>(end) + 1, stem.end(),
                                    [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; });
  return numbered ? stem.substr(0, end) : stem;
}

std::vector<BodyId> in_order_of_making(const World& world) {
  std::vector<BodyId> bodies = world.bodies.ids();
  std::sort(bodies.begin(), bodies.end(),
            [&](BodyId a, BodyId b) { return world.bodies[a].serial < world.bodies[b].serial; });
  return bodies;
}

bool at_rest_alike(const Motion& a, const Motion& b) {
  return same(a.x, b.x) && same(a.p, b.p) && same(a.angular, b.angular) && a.mass == b.mass && same(a.q, b.q);
}

/// What is not the same in what was opened again; empty where all is.
std::string difference(const World& now, const World& again) {
  const auto counts = [&](const char* what, std::size_t here, std::size_t there) {
    return here == there ? std::string() : text("there are ", here, " ", what, " here, and ", there, " in the file");
  };
  if (auto told = counts("bodies", now.bodies.size(), again.bodies.size()); !told.empty()) return told;
  if (auto told = counts("connections", now.connections.size(), again.connections.size()); !told.empty()) return told;
  if (now.time > 0.0) return {};
  const std::vector<BodyId> here = in_order_of_making(now), there = in_order_of_making(again);
  for (std::size_t i = 0; i < here.size(); i++)
    if (!at_rest_alike(now.motion_of(here[i]), again.motion_of(there[i])))
      return describe(now, here[i]) + " is not to the bit where it is here";
  return {};
}

}  // namespace

std::string free_scene_name(const std::string& script, const std::string& folder) {
  char number[16];
  fs::path name;
  int next = 1;
  do {
    std::snprintf(number, sizeof number, "-%04d.lua", next++);
    name = fs::path(folder) / (plain_stem(script) + number);
  } while (fs::exists(name));
  return folder == "." ? name.filename().string() : name.string();
}

SavedScene save_scene(const Scene& scene, const std::string& script, const std::string& source, SceneOptions options,
                      const std::string& file) {
  options.on_read = nullptr;
  options.save = [](const std::string&, const std::string&) {};
  const fs::path path(script);
  const std::unique_ptr<Scene> opened = lua::open_scene_text(source, path.filename(), path.parent_path(), options);
  LuaOfThings made = lua_of_things(scene.world(), opened->world());
  const bool ends_line = source.empty() || source.back() == '\n';
  const std::string whole = source + (ends_line ? "" : "\n") + made.text;
  const fs::path target(file);
  std::unique_ptr<Scene> again;
  try {
    again = lua::open_scene_text(whole, target.filename(), target.parent_path(), options);
  } catch (const std::exception& error) {
    throw Error(text("what was built cannot be saved as a scene, for it would not open: ", error.what()));
  }
  SavedScene saved{file, std::move(made.left_out)};
  if (std::string told = difference(scene.world(), again->world()); !told.empty())
    saved.left_out.push_back(std::move(told));
  Output output(file);
  output.write(whole);
  output.keep();
  return saved;
}

}  // namespace pantin::player
