#pragma once
// What a scene is, inside: its Lua state, its world, and what the script declared.
#include <deque>
#include <lua.hpp>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "lua/law/recheck.hpp"
#include "lua/thing/handles.hpp"
#include "lua/value/callback.hpp"
#include "lua/vm/runtime.hpp"
#include "scene/drawing.hpp"
#include "scene/options.hpp"
#include "scene/scene.hpp"
#include "scene/sound.hpp"
#include "snapshot/carry_over.hpp"
#include "world/world.hpp"

namespace pantin::lua {

struct ScriptSnapshot;

/// A function that waits for something: `scene:on(name, function)`; or a behaviour, which waits for "step".
struct Subscription {
  std::uint64_t serial;
  std::string name;
  std::optional<Callback> function;  ///< empty: cancelled
  AnyId target = {};                 ///< of a behaviour; of "touched" and "parted" what it waits for: it ends with this
  std::optional<Callback> stop = {};
  std::string key = {};    ///< of the moment "key": the only one it waits for, or empty
  std::string layer = {};  ///< of "touched" and "parted": what it waits for, where that is no thing, or empty
};

/// A layer that a script spoke of in a call that gives it to nothing.
struct SpokenLayer {
  std::string call;  ///< "scene.lua:12: collide"
  std::string layer;
};

/// What a snapshot copies of a script.
struct ScriptData {
  std::string title;
  std::optional<double> duration;  ///< [s]
  double pace = 1.0;               ///< simulated s per real s
  CameraWish camera;
  bool dark = false;  ///< shown on a dark ground
  bool finished = false;
  NextScene next;              ///< to be opened when the step is done
  std::string contact_sounds;  ///< what touches is heard as: "", "by material", or a sound's name

  std::vector<SceneParameter> parameters;
  std::map<std::string, Callback> on_change;
  std::vector<std::string> buttons;
  std::map<std::string, Callback> button_functions;
  std::map<std::string, SceneValue> results;
  std::vector<Drawing> drawings;            ///< of the last step, or from before the first
  std::vector<SoundCall> sounds;            ///< the same
  std::vector<Subscription> subscriptions;  ///< in the order of asking
  std::size_t cancelled = 0;                ///< subscriptions that are only there to be dropped
  LawsAtWork laws;
};

/// Where a script runs. It outlives all that holds functions of it.
struct ScriptHost {
  SceneOptions options;
  Runtime runtime;
};

struct Script : ScriptHost, ScriptData {
  explicit Script(const SceneOptions& options);

  World world;

  Made made;                                         ///< by the file, where it may change
  std::set<std::string> fixed;                       ///< settings that `--set` gave: what the file assigns is ignored
  std::set<std::string> controls;                    ///< of keys, gamepads and the mouse, that were read: the scene's
  std::uint64_t subscribed = 0;                      ///< serial of the last subscription
  AnyId told_of;                                     ///< what the notice is of that is told now
  int telling = 0;                                   ///< calls that go through the subscriptions now
  std::shared_ptr<const ScriptSnapshot> start;       ///< before the first step, where a file speaks of `reset`
  std::string no_start;                              ///< why it could not be kept
  std::shared_ptr<const ScriptSnapshot> wanted;      ///< to be restored when the step is done
  double history = 0.0;                              ///< [s] for which states are kept, see `ring`
  std::deque<std::shared_ptr<ScriptSnapshot>> ring;  ///< of the last steps, oldest first
  std::string save_as;                               ///< the state is to be saved by that name when the step is done
  std::string saves_at;                              ///< "scene.lua:12", which asked for that
  std::uint64_t snapshots = 0;                       ///< that the script took
  std::size_t data_count = 0;                        ///< tables of things' data
  std::size_t data_sweep = 64;                       ///< count at which the dead ones are dropped
  std::vector<SpokenLayer> spoken_layers;            ///< since the last step
  std::map<std::string, std::shared_ptr<const Picture>> pictures;  ///< that were read, by their names

  /// Addresses are keys of the Lua registry: per kind the handles given out, then their data, then scene.store.
  std::array<char, kind_count + 2> keys{};
};

/// Of a C function that has it as its first upvalue.
Script& script_of(lua_State* state);

}  // namespace pantin::lua
