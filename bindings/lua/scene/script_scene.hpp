#pragma once
// A scene that is a Lua script.
#include <utility>

#include "lua/thing/script.hpp"
#include "scene/scene.hpp"

namespace pantin::lua {

class ScriptScene final : public Scene {
 public:
  explicit ScriptScene(const SceneOptions& options);

  World& world() override { return script_.world; }
  const World& world() const override { return script_.world; }
  void step() override;

  const std::string& file() const override { return script_.runtime.name; }
  const std::string& title() const override { return script_.title; }
  std::optional<double> duration() const override { return script_.duration; }
  double pace() const override { return script_.pace; }
  CameraWish camera() const override { return script_.camera; }
  bool dark() const override { return script_.dark; }
  bool finished() const override { return script_.finished; }

  const std::vector<SceneParameter>& parameters() const override { return script_.parameters; }
  bool set_parameter(const std::string& name, const SceneValue& value) override;
  std::vector<std::string> keys() const override;
  std::vector<std::string> controls() const override { return {script_.controls.begin(), script_.controls.end()}; }
  std::vector<std::string> behaviours() const override;
  std::span<const SoundCall> sounds() const override { return script_.sounds; }
  NextScene take_next() override { return std::exchange(script_.next, {}); }
  const std::vector<std::string>& buttons() const override { return script_.buttons; }
  const std::map<std::string, SceneValue>& results() const override { return script_.results; }
  const std::string& broken_off() const override { return script_.runtime.broken_off; }
  const std::vector<Drawing>& drawings() const override { return script_.drawings; }

  std::shared_ptr<const SceneSnapshot> take_snapshot() override;
  void restore(const SceneSnapshot& snapshot) override;
  std::string state() override;
  CarriedOver go_on_from(Scene& old) override;

  /// The inside, for the bindings alone.
  Script& script() { return script_; }

 private:
  Script script_;
};

/// The inside of a scene that is a Lua script; throws Error of any other.
Script& script_of(Scene& scene);
/// One step of the world, with what the script draws in it, and the restore that a callback asked for.
void step_scene(Script& script);

}  // namespace pantin::lua
