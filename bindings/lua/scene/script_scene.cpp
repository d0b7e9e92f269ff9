#include "lua/scene/script_scene.hpp"

#include "lua/law/recheck.hpp"
#include "lua/scene/carry_tables.hpp"
#include "lua/scene/events.hpp"
#include "lua/scene/layers.hpp"
#include "lua/scene/parameters.hpp"
#include "lua/scene/snapshot.hpp"
#include "lua/scene/state_file.hpp"
#include "step/step.hpp"

namespace pantin::lua {

void step_scene(Script& script) {
  restore_wanted(script);
  save_wanted(script);
  keep_start(script);
  script.drawings.clear();
  script.sounds.clear();
  step(script.world);
  tell_unknown_layers(script);
  restore_wanted(script);
  keep_history(script);
  save_wanted(script);
}

Script& script_of(Scene& scene) {
  auto* of_lua = dynamic_cast<ScriptScene*>(&scene);
  require(of_lua, "this scene is not a Lua script");
  return of_lua->script();
}

ScriptScene::ScriptScene(const SceneOptions& options) : script_(options) {
  script_.world.behaviours = [this] { run_behaviours(script_); };
}

void ScriptScene::step() {
  const Outside outside;
  step_scene(script_);
}

bool ScriptScene::set_parameter(const std::string& name, const SceneValue& value) {
  const Outside outside;
  const bool live = change_parameter(script_, name, value);
  renew_laws(script_.world, script_.laws);
  return live;
}

std::vector<std::string> ScriptScene::keys() const {
  std::vector<std::string> keys;
  for (const Subscription& s : script_.subscriptions)
    if (s.function && !s.key.empty()) keys.push_back(s.key);
  return keys;
}

std::vector<std::string> ScriptScene::behaviours() const {
  std::vector<std::string> places;
  for (const Subscription& s : script_.subscriptions)
    if (s.function && s.name == "step") places.push_back(s.function->place());
  return places;
}

std::shared_ptr<const SceneSnapshot> ScriptScene::take_snapshot() { return lua::take_snapshot(script_); }

void ScriptScene::restore(const SceneSnapshot& snapshot) {
  const Outside outside;
  lua::restore(script_, dynamic_cast<const ScriptSnapshot&>(snapshot));
}

std::string ScriptScene::state() {
  const Outside outside;
  return state_of(script_);
}

CarriedOver ScriptScene::go_on_from(Scene& old) {
  const Outside outside;
  Script& from = script_of(old);
  keep_start(script_);
  CarriedOver carried = carry_over(from.world, from.made, script_.world, script_.made);
  carry_tables(from, script_, carried.things);
  return carried;
}

}  // namespace pantin::lua
