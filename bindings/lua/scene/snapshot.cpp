#include "lua/scene/snapshot.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "lua/law/recheck.hpp"
#include "lua/scene/parameters.hpp"
#include "lua/scene/scene_type.hpp"
#include "lua/thing/fields.hpp"
#include "lua/thing/targets.hpp"
#include "lua/value/arguments.hpp"
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

namespace {
std::shared_ptr<ScriptSnapshot> take_own_snapshot(Script& script) {
  std::shared_ptr<ScriptSnapshot> snapshot;
  script.runtime.run([&](lua_State* state) {
    sweep_data(state, script);
    snapshot = std::make_shared<ScriptSnapshot>(state, script);
  });
  snapshot->world = pantin::take_snapshot(script.world);
  return snapshot;
}
}  // namespace

std::shared_ptr<const ScriptSnapshot> take_snapshot(Script& script) { return take_own_snapshot(script); }

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
  renew_laws(script.world, script.laws);
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

void keep_history(Script& script) {
  std::deque<std::shared_ptr<ScriptSnapshot>>& ring = script.ring;
  const World& world = script.world;
  // What is later than the present was taken back.
  while (!ring.empty() && ring.back()->world.steps() >= world.steps) ring.pop_back();
  const double oldest = world.time - script.history - 0.5 * world.settings.step;
  while (!ring.empty() && (script.history == 0.0 || ring.front()->world.time() < oldest)) ring.pop_front();
  if (script.history > 0.0 && why_not_restore(world).empty()) ring.push_back(take_own_snapshot(script));
}

int scene_rewind(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "rewind");
  const double seconds = check_number(state, 2, "rewind", "argument 1", "s");
  require(seconds >= 0.0, "rewind: argument 1 must be >= 0 s, got ", seconds);
  const auto& ring = self.script.ring;
  require(self.script.history > 0.0, "rewind: no states are kept; say for how long by scene.history, in s");
  const double wanted = self.world.time - seconds + 0.5 * self.world.settings.step;
  const auto later = std::upper_bound(ring.begin(), ring.end(), wanted, [](double time, const auto& state_then) {
    return time < state_then->world.time();
  });
  require(later != ring.begin(), "rewind: states are kept from ",
          ring.empty() ? self.world.time : ring.front()->world.time(), " s on, and ", seconds, " s ago is before that");
  return want(self, "rewind", *std::prev(later));
}

int scene_save(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "save");
  require_unlocked(self.world, "save");
  const std::string name = check_text(state, 2, "save", "argument 1, the file,");
  require(!name.empty(), "save: argument 1, the file, must not be empty");
  require(static_cast<bool>(self.script.options.save), "save: files are not written here");
  self.script.save_as = name;
  self.script.saves_at = where(state);
  return 0;
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
