#pragma once
// A scene: a Lua file that was run, and the world it built.
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "scene/drawing.hpp"
#include "scene/errors.hpp"
#include "scene/options.hpp"
#include "snapshot/carry_over.hpp"
#include "world/world.hpp"

namespace pantin::lua {

struct Script;
struct SceneSnapshot;

struct CameraWish {
  std::optional<Vec3> at, look_at;  ///< [m]
  AnyId follow;
};

/// Owns a Lua state and a World. Every call that runs a script throws Error whose text starts with "file.lua:line: ".
class Scene {
 public:
  /// Runs the file. Errors of wrong use (no such file, `--set` of an unknown parameter) throw UsageError.
  static std::unique_ptr<Scene> open(const std::string& path, const SceneOptions& options);
  /// The same for a text, called `name` in messages; `require` looks in `folder`.
  static std::unique_ptr<Scene> open_text(const std::string& source, const std::string& name, const std::string& folder,
                                          const SceneOptions& options);
  ~Scene();

  World& world();
  const World& world() const;
  /// One step of the world with the script's callbacks; sets `finished` when the script asked for it.
  void step();

  const std::string& title() const;
  std::optional<double> duration() const;  ///< [s]
  double pace() const;                     ///< simulated s per real s
  CameraWish camera() const;
  bool finished() const;

  const std::vector<SceneParameter>& parameters() const;
  /// Applies a value live and returns true, or returns false: the scene must be opened again with it.
  bool set_parameter(const std::string& name, const SceneValue& value);
  std::vector<std::string> keys() const;            ///< that the script asked for by their names
  const std::vector<std::string>& buttons() const;  ///< names; press one by a Command of the world's input
  const std::map<std::string, SceneValue>& results() const;
  std::vector<std::string> warnings() const;
  std::vector<std::string> notices() const;
  const std::vector<Drawing>& drawings() const;  ///< what the script drew in the last step

  /// The present state: the world's, what the script declared, `scene.store` and the `data` of things. Between two steps;
  /// must not outlive the scene. Throws Error where something in `scene.store` is not plain.
  std::shared_ptr<const SceneSnapshot> take_snapshot();
  /// Puts it back, between two steps: `world()` stays the same object, and handles are those they were. A parameter that
  /// has another value is told its old one by its `on_change` first. Throws Error where `why_not_restore` says why.
  void restore(const SceneSnapshot& snapshot);
  /// Why nothing can be restored now: a play goes on, which cannot be wound back. Empty where it can.
  std::string why_not_restore() const;

  /// Goes on where an older scene is, whose files were changed since; both were opened as `changing`. Things are matched
  /// by name, else by sort and order of making, see world/carry_over. `scene.store` and the `data` of things come along
  /// as far as they are plain. Before the first step.
  CarriedOver go_on_from(Scene& old);
  /// The inside, for the bindings alone.
  Script& script();

 private:
  struct State;
  explicit Scene(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// One step of the world, with what the script draws in it, and the restore that a callback asked for.
void step_scene(Script& script);

}  // namespace pantin::lua
