#pragma once
// A scene as the program knows it, in whatever language it is written: a world, and what was declared beside it.
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scene/drawing.hpp"
#include "scene/options.hpp"
#include "scene/sound.hpp"
#include "snapshot/carry_over.hpp"
#include "world/world.hpp"

namespace pantin {

struct CameraWish {
  std::optional<Vec3> at, look_at;  ///< [m]
  AnyId follow;
  double zoom = 1.0;  ///< how many times nearer than from where all is seen, or than `at`
  double ease = 0.0;  ///< [s] with which it moves to where it is wished; 0: at once

  bool operator==(const CameraWish& other) const;
};

/// A state that a scene was in; what is in it only that scene knows.
struct SceneSnapshot {
  SceneSnapshot() = default;
  virtual ~SceneSnapshot() = default;
  SceneSnapshot(const SceneSnapshot&) = delete;
  SceneSnapshot& operator=(const SceneSnapshot&) = delete;
};

/// Every call that runs a script throws Error whose text starts with "file:line: ".
class Scene {
 public:
  Scene() = default;
  virtual ~Scene() = default;
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  virtual World& world() = 0;
  virtual const World& world() const = 0;
  /// One step of the world with the script's callbacks; sets `finished` when the script asked for it.
  virtual void step() = 0;

  virtual const std::string& file() const = 0;  ///< its name, as messages call it
  virtual const std::string& title() const = 0;
  virtual std::optional<double> duration() const = 0;  ///< [s]
  virtual double pace() const = 0;                     ///< simulated s per real s
  virtual CameraWish camera() const = 0;
  virtual bool dark() const { return false; }  ///< shown on a dark ground
  virtual bool finished() const = 0;

  virtual const std::vector<SceneParameter>& parameters() const = 0;
  /// Applies a value live and returns true, or returns false: the scene must be opened again with it.
  virtual bool set_parameter(const std::string& name, const SceneValue& value) = 0;
  virtual std::vector<std::string> keys() const = 0;  ///< that the script asked for by their names
  virtual std::vector<std::string> controls() const {
    return {};
  }  ///< of keys, gamepads and the mouse, that the script read
  virtual std::vector<std::string> behaviours() const { return {}; }  ///< where the script has what acts in each step
  virtual const std::vector<std::string>& buttons() const = 0;  ///< names; press one by a Command of the world's input
  virtual const std::map<std::string, SceneValue>& results() const = 0;
  virtual const std::vector<Drawing>& drawings() const = 0;         ///< what the script drew in the last step
  virtual std::span<const SoundCall> sounds() const { return {}; }  ///< that began in the last step
  /// The first error, with its line, that ended only what an event did, so that the scene goes on; empty: none.
  virtual const std::string& broken_off() const;
  /// The scene that it wants to be opened now, once; else none.
  virtual NextScene take_next() { return {}; }
  /// What the world's log has of them.
  std::vector<std::string> warnings() const;
  std::vector<std::string> notices() const;

  /// The present state: the world's, what the script declared, `scene.store` and the `data` of things. Between two steps;
  /// must not outlive the scene. Throws Error where something in `scene.store` is not plain.
  virtual std::shared_ptr<const SceneSnapshot> take_snapshot() = 0;
  /// Puts back one of its own, between two steps: `world()` stays the same object, and handles are those they were. A
  /// parameter that has another value is told its old one by its `on_change` first. Throws Error where `why_not_restore`
  /// says why.
  virtual void restore(const SceneSnapshot& snapshot) = 0;
  /// The present state with all that the scene is made of, for a file: another process goes on from it to the same bits.
  /// Between two steps. Throws Error where something in it cannot be kept in a file.
  virtual std::string state() = 0;
  /// Why nothing can be restored now: a play goes on, which cannot be wound back. Empty where it can.
  std::string why_not_restore() const;

  /// Goes on where an older scene is, whose files were changed since; both were opened as `changing`. Things are matched
  /// by name, else by sort and order of making, see snapshot/carry_over. `scene.store` and the `data` of things come along
  /// as far as they are plain. Before the first step. Throws Error where the older one is of another language.
  virtual CarriedOver go_on_from(Scene& old) = 0;
};

/// As `--set` gives it.
std::string setting_text(const SceneValue& value);
/// Sets what a scene's parameters are now, where it is not what they are without.
void take_parameters(const Scene& scene, std::map<std::string, std::string>& set);

}  // namespace pantin
