#include "lua/scene/snapshot.hpp"

#include <utility>

#include "lua/scene/parameters.hpp"
#include "lua/scene/scene_type.hpp"
#include "lua/thing/fields.hpp"
#include "lua/thing/targets.hpp"
#include "lua/vm/guard.hpp"

namespace pantin::lua {
namespace {

const void* key_of_data(const Script& script) { return &script.keys[kind_count]; }
const void* key_of_store(const Script& script) { return &script.keys[kind_count + 1]; }

/// What the parameters of a live script were is told to the script first: an error then leaves all as it is.
void tell_parameters(Script& script, const std::vector<SceneParameter>& before) {
  for (const SceneParameter& old : before)
    for (const SceneParameter& now : std::vector<SceneParameter>(script.parameters))
      if (now.name == old.name && now.live && now.value != old.value) change_parameter(script, old.name, old.value);
}

struct SnapshotRef : Ref {
  std::shared_ptr<const ScriptSnapshot> value;
};

int drop_snapshot(lua_State* state) {
  static_cast<SnapshotRef*>(lua_touserdata(state, 1))->value.reset();
  return 0;
}

void require_unlocked(const World& world, const char* call) {
  require(!world.locked, call,
          ": it cannot be called while the world steps; call it in an event, a step callback or a button");
}

}  // namespace

ScriptSnapshot::ScriptSnapshot(lua_State* state, Script& of) : script(of), tables(state), runtime_(of.runtime) {
  push_store(state, of);
  tables.keep_plain(state, -1, "scene.store");
  if (lua_rawgetp(state, LUA_REGISTRYINDEX, key_of_data(of)) == LUA_TTABLE) tables.keep(state, -1);
  lua_pop(state, 1);
  store_ = luaL_ref(state, LUA_REGISTRYINDEX);
}

ScriptSnapshot::~ScriptSnapshot() { luaL_unref(runtime_.active(), LUA_REGISTRYINDEX, store_); }

void ScriptSnapshot::put_back(lua_State* state, Script& into) const {
  tables.put_back(state);
  lua_rawgeti(state, LUA_REGISTRYINDEX, store_);
  lua_rawsetp(state, LUA_REGISTRYINDEX, key_of_store(into));
}

std::shared_ptr<const ScriptSnapshot> take_snapshot(Script& script) {
  std::shared_ptr<ScriptSnapshot> snapshot;
  script.runtime.run([&](lua_State* state) {
    sweep_data(state, script);
    snapshot = std::make_shared<ScriptSnapshot>(state, script);
  });
  const Outside outside;
  snapshot->world = pantin::take_snapshot(script.world);
  return snapshot;
}

void restore(Script& script, const ScriptSnapshot& snapshot) {
  const std::string why = why_not_restore(script.world, snapshot.world);
  require(why.empty(), "restore: ", why);
  tell_parameters(script, snapshot.script.parameters);
  pantin::restore(script.world, snapshot.world);
  static_cast<ScriptData&>(script) = snapshot.script;
  script.runtime.run([&](lua_State* state) {
    snapshot.put_back(state, script);
    sweep_data(state, script);
  });
}

void restore_wanted(Script& script) {
  if (const auto wanted = std::exchange(script.wanted, nullptr)) restore(script, *wanted);
}

void keep_start(Script& script) {
  if (script.world.steps != 0 || script.start || !script.runtime.speaks_of_reset) return;
  try {
    script.start = take_snapshot(script);
  } catch (const Error& error) { script.no_start = error.what(); }
}

void push_snapshot(lua_State* state, Script& script, std::shared_ptr<const ScriptSnapshot> snapshot) {
  const Ref ref = make_ref(script, Kind::snapshot, 1, 1, 0);
  new (lua_newuserdatauv(state, sizeof(SnapshotRef), 0)) SnapshotRef{ref, std::move(snapshot)};
  push_metatable(state, Kind::snapshot);
  lua_pushcfunction(state, drop_snapshot);
  lua_setfield(state, -2, "__gc");
  lua_setmetatable(state, -2);
}

std::shared_ptr<const ScriptSnapshot> check_snapshot(lua_State* state, int index, const Script& script) {
  const Ref* ref = to_ref(state, index);
  require(ref && ref->kind == Kind::snapshot, "restore: argument 1 must be a snapshot, got ",
          kind_of_value(state, index));
  require(ref->script == &script, "restore: this is a snapshot of another scene");
  return static_cast<const SnapshotRef*>(ref)->value;
}

int scene_snapshot(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "snapshot");
  require_unlocked(self.world, "snapshot");
  // Lua does not know how large they are, and would let them pile up.
  if (++self.script.snapshots % 16 == 0) lua_gc(state, LUA_GCCOLLECT);
  push_snapshot(state, self.script, take_snapshot(self.script));
  return 1;
}

namespace {
int want(const Self& self, const char* call, const std::shared_ptr<const ScriptSnapshot>& snapshot) {
  require_unlocked(self.world, call);
  const std::string why = why_not_restore(self.world, snapshot->world);
  require(why.empty(), call, ": ", why);
  self.script.wanted = snapshot;
  return 0;
}
}  // namespace

int scene_restore(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "restore");
  return want(self, "restore", check_snapshot(state, 2, self.script));
}

int scene_reset(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "reset");
  if (self.world.steps == 0 && self.world.step_origin == 0.0) return 0;
  require(self.script.start || !self.script.no_start.empty(),
          "reset: the start was not kept; it is where a file of the scene has the word reset");
  require(self.script.start != nullptr, "reset: the start could not be kept: ", self.script.no_start);
  return want(self, "reset", self.script.start);
}

const Type& snapshot_type() {
  static const Type type = {
      "Snapshot",
      "snapshot",
      "A state of the scene, to which scene:restore goes back: the world, scene.store and the data of things; not what "
      "a "
      "script keeps in its variables.",
      {{"time", "number", "s", "of the scene when it was taken",
        [](const Self& s) { lua_pushnumber(s.state, static_cast<const SnapshotRef&>(s.ref).value->world.time()); },
        nullptr}},
      {}};
  return type;
}

}  // namespace pantin::lua
