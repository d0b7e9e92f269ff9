#pragma once
// Snapshots of a scene: of its world, of what the script declared, of `scene.store` and of the `data` of things. What the
// script keeps in its own variables is not part of them.
#include <lua.hpp>
#include <memory>

#include "lua/thing/kept_tables.hpp"
#include "lua/thing/script.hpp"
#include "scene/scene.hpp"
#include "snapshot/snapshot.hpp"

namespace pantin::lua {

struct ScriptSnapshot final : SceneSnapshot {
  /// All but the world's.
  ScriptSnapshot(lua_State* state, Script& of);
  ~ScriptSnapshot() override;
  /// The tables of the scene.
  void put_back(lua_State* state, Script& into) const;

  Snapshot world;
  ScriptData script;
  KeptTables tables;

 private:
  Runtime& runtime_;
  int store_;  ///< registry reference of the table that `scene.store` was
};

std::shared_ptr<const ScriptSnapshot> take_snapshot(Script& script);
/// Between two steps. Parameters that have another value are told their old one by `on_change` first.
void restore(Script& script, const ScriptSnapshot& snapshot);
/// Restores what a callback asked for, if one did.
void restore_wanted(Script& script);
/// Before the first step of a scene that speaks of `reset`, keeps its start, or why it cannot be kept.
void keep_start(Script& script);

void push_snapshot(lua_State* state, Script& script, std::shared_ptr<const ScriptSnapshot> snapshot);
/// Argument `index` of `restore`: a snapshot of this scene.
std::shared_ptr<const ScriptSnapshot> check_snapshot(lua_State* state, int index, const Script& script);

int scene_snapshot(lua_State* state);
int scene_restore(lua_State* state);
int scene_reset(lua_State* state);
int scene_save(lua_State* state);
int scene_rewind(lua_State* state);
/// After a step: keeps its state where the script wants a history, and drops what is too old.
void keep_history(Script& script);

}  // namespace pantin::lua
