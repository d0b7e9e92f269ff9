#include "lua/scene/layers.hpp"

#include <algorithm>

#include "lua/value/arguments.hpp"
#include "lua/vm/guard.hpp"

namespace pantin::lua {
namespace {

/// Layers that shapes and solid families have.
std::vector<std::string> layers_of_things(const World& world) {
  std::vector<bool> had(world.layers.names.size() + 1, false);
  for (const ShapeId id : world.shapes.ids()) had[world.shapes[id].layer] = true;
  for (const FamilyId id : world.families.ids())
    if (const auto& solid = world.families[id].solid) had[solid->layer] = true;
  std::vector<std::string> names;
  for (std::size_t i = 1; i < had.size(); i++)
    if (had[i]) names.push_back(world.layers.names[i - 1]);
  return names;
}

}  // namespace

void speak_of_layer(Script& script, lua_State* state, std::string_view call, const std::string& layer) {
  script.spoken_layers.push_back({text(where(state), ": ", call), layer});
}

void tell_unknown_layers(Script& script) {
  if (script.spoken_layers.empty()) return;
  World& world = script.world;
  const std::vector<std::string> names = layers_of_things(world);
  for (const SpokenLayer& spoken : script.spoken_layers) {
    if (std::find(names.begin(), names.end(), spoken.layer) != names.end()) continue;
    std::vector<std::string> alike;  // words that differ from the first letter on are other words
    for (const std::string& name : names)
      if (name[0] == spoken.layer[0]) alike.push_back(name);
    const std::string near = suggestion(spoken.layer, alike);
    if (near.empty()) continue;
    const std::string what = text(spoken.call, ": nothing has the layer '", spoken.layer, "'.", near);
    const auto told = [&](const LogLine& line) { return line.text == what; };
    if (std::none_of(world.log.begin(), world.log.end(), told)) log_line(world, "warning", what);
  }
  script.spoken_layers.clear();
}

}  // namespace pantin::lua
