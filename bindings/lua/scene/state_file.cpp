#include "lua/scene/state_file.hpp"

#include <algorithm>
#include <cstring>

#include "base/hash.hpp"
#include "lua/law/force_library.hpp"
#include "lua/law/recheck.hpp"
#include "lua/scene/heap.hpp"
#include "lua/scene/kept_functions.hpp"
#include "lua/scene/open.hpp"
#include "lua/scene/scene_type.hpp"
#include "lua/scene/script_scene.hpp"
#include "lua/value/tostring.hpp"
#include "measure/measure.hpp"
#include "scene/errors.hpp"
#include "scene/headway.hpp"
#include "scene/interrupt.hpp"
#include "snapshot/snapshot.hpp"

namespace pantin::lua {
namespace {

constexpr std::string_view magic{"pantin state\n\0\0", 16};

/// Stands before the state.
struct FileHead {
  char magic[16];
  std::uint64_t layout, size, hash;
};

std::uint64_t hash_of(const FileHead& head, std::string_view body) {
  Hash hash;
  hash.add(head.layout);
  hash.add(head.size);
  for (; !body.empty(); body.remove_prefix(std::min<std::size_t>(8, body.size()))) {
    std::uint64_t word = 0;
    std::memcpy(&word, body.data(), std::min<std::size_t>(8, body.size()));
    hash.add(word);
  }
  return hash.value;
}

template <class A>
void each(A& a, auto&... part) {
  (visit(a, part), ...);
}

Callback callback_of(HeapWriter& heap, const Callback* callback) {
  heap.function(*callback);
  return *callback;
}
Callback callback_of(HeapReader& heap, const Callback*) { return heap.function(); }

template <class Heap, class A>
void visit_callback(Heap& heap, A& a, std::optional<Callback>& callback) {
  bool has = callback.has_value();
  visit(a, has);
  if (!has) return callback.reset();
  Callback there = callback_of(heap, callback ? &*callback : nullptr);
  callback.emplace(std::move(there));
}

template <class Heap, class A>
void visit_callbacks(Heap& heap, A& a, std::map<std::string, Callback>& callbacks) {
  const std::size_t size = visit_size(a, callbacks.size());
  if constexpr (A::reads) {
    callbacks.clear();
    for (std::size_t i = 0; i < size; i++) {
      std::string name;
      visit(a, name);
      callbacks.insert_or_assign(name, heap.function());
    }
  } else {
    for (auto& [name, callback] : callbacks) {
      visit(a, const_cast<std::string&>(name));
      heap.function(callback);
    }
  }
}

template <class Heap, class A>
void visit_script(Heap& heap, A& a, Script& s) {
  each(a, s.title, s.duration, s.pace, s.camera.at, s.camera.look_at, s.camera.follow, s.camera.zoom, s.camera.ease,
       s.dark, s.finished, s.next, s.controls, s.contact_sounds, s.parameters, s.buttons, s.results, s.drawings,
       s.cancelled, s.fixed, s.subscribed, s.history);
  visit_callbacks(heap, a, s.on_change);
  visit_callbacks(heap, a, s.button_functions);
  std::size_t size = visit_size(a, s.subscriptions.size());
  if constexpr (A::reads) s.subscriptions.assign(size, Subscription{});
  for (Subscription& subscription : s.subscriptions) {
    each(a, subscription.serial, subscription.name, subscription.target, subscription.key, subscription.layer);
    visit_callback(heap, a, subscription.function);
    visit_callback(heap, a, subscription.stop);
  }
  size = visit_size(a, s.laws.traced.size());
  if constexpr (A::reads) s.laws.traced.resize(size);
  for (TracedAtWork& traced : s.laws.traced) {
    each(a, traced.id, traced.traced_again);
    visit_law(heap, a, traced.law);
  }
}

/// Laws of the library that the script has made so far: what is made from now on may be the same.
template <class A>
void visit_known_laws(A& a, KnownLaws& laws) {
  const std::size_t size = visit_size(a, laws.size());
  const auto visit_list = [&](std::vector<std::shared_ptr<const Law>>& list) {
    const std::size_t count = visit_size(a, list.size());
    if constexpr (A::reads) list.resize(count);
    for (auto& law : list) pantin::visit_law(a, law);
  };
  if constexpr (A::reads) {
    for (std::size_t i = 0; i < size; i++) {
      std::string name;
      visit(a, name);
      visit_list(laws[name]);
    }
  } else {
    for (auto& [name, list] : laws) {
      visit(a, const_cast<std::string&>(name));
      visit_list(list);
    }
  }
}

const void* data_key(const Script& script) { return &script.keys[kind_count]; }
const void* store_key(const Script& script) { return &script.keys[kind_count + 1]; }

void visit_sources(auto& a, Script& script) {
  Runtime& runtime = script.runtime;
  each(a, runtime.name, runtime.chunks, runtime.files, runtime.folder, runtime.speaks_of_reset, script.options.set);
}

/// Numbers by which the script has shown what it still has.
void write_shown(HeapWriter& heap, lua_State* state, Script& script, Writer& to) {
  push_shown(state);
  lua_pushnil(state);
  while (lua_next(state, -2)) {
    const int value = lua_gettop(state);
    if (heap.has(value - 1)) {
      heap.value(value, "");
      heap.value(value - 1, "");
    }
    lua_pop(state, 1);
  }
  lua_pushnil(state);
  heap.value(lua_gettop(state), "");
  lua_pop(state, 2);
  visit(to, script.runtime.shown);
}

void read_shown(HeapReader& heap, lua_State* state, Script& script, Reader& from) {
  push_shown(state);
  for (heap.value(); !lua_isnil(state, -1); heap.value()) {
    heap.value();
    lua_insert(state, -2);
    lua_rawset(state, -3);
  }
  lua_pop(state, 2);
  visit(from, script.runtime.shown);
}

void write_all(lua_State* state, Script& script, Writer& to) {
  sweep_data(state, script);
  HeapWriter heap(state, script, to);
  KeptFunctions functions(script, &heap, nullptr);
  to.outside = &functions;
  visit_world(to, script.world);
  visit_script(heap, to, script);
  visit_known_laws(to, known_laws(state));
  const auto put = [&](const char* name) {
    heap.value(lua_gettop(state), name);
    lua_pop(state, 1);
  };
  push_store(state, script);
  put("scene.store");
  lua_rawgetp(state, LUA_REGISTRYINDEX, data_key(script));
  put("data");
  heap.contents();
  write_shown(heap, state, script, to);
}

void read_all(lua_State* state, Script& script, Reader& from) {
  HeapReader heap(state, script, from);
  KeptFunctions functions(script, nullptr, &heap);
  from.outside = &functions;
  visit_world(from, script.world);
  visit_script(heap, from, script);
  visit_known_laws(from, known_laws(state));
  heap.value();
  require(lua_istable(state, -1), "its scene.store is no table");
  lua_rawsetp(state, LUA_REGISTRYINDEX, store_key(script));
  heap.value();
  require(lua_isnoneornil(state, -1) || lua_istable(state, -1), "its data is no table");
  lua_rawsetp(state, LUA_REGISTRYINDEX, data_key(script));
  heap.contents();
  read_shown(heap, state, script, from);
  require(from.rest.empty(), "there is more in it than there should be");
  for (TracedAtWork& traced : script.laws.traced) find_captured(traced.law);
  heap.each_law([](LawSpec& spec) {
    for (LawSpec::Ready& ready : spec.ready) find_captured(ready.law);
  });
  script.laws.runs_seen = script.runtime.runs();
  sweep_data(state, script);
}

/// Files that the state has, then others.
void read_kept_files_first(Script& script) {
  script.runtime.reader = [files = script.runtime.files, other = script.runtime.reader](
                              const std::string& path, std::size_t largest) -> std::optional<std::string> {
    const auto kept = files.find(path);
    if (kept != files.end()) return kept->second;
    return other(path, largest);
  };
}

/// What was read may hold functions of the script: it goes before that does.
struct SharedEnd {
  Reader& from;
  ~SharedEnd() { from.known.clear(); }
};

std::unique_ptr<Scene> scene_with(Reader& from, const SceneOptions& options) {
  auto scene = std::make_unique<ScriptScene>(options);
  const SharedEnd end{from};
  Script& script = scene->script();
  script.runtime.run([&](lua_State* state) {
    open_globals(state, script);
    note_permanents(state);
  });
  visit_sources(from, script);
  read_kept_files_first(script);
  script.runtime.run([&](lua_State* state) { read_all(state, script, from); });
  if (script.runtime.speaks_of_reset)
    script.no_start = "it is not in the file of the state that the scene went on from";
  return scene;
}

/// How far a scene had come whose script waits: nobody but the script was at work, so it does the same again.
struct WayCome {
  std::uint64_t steps = 0;
  double time = 0.0;  ///< [s]
  std::uint64_t hash = 0;
};

/// Throws Error where it leads elsewhere, and Interrupted where the program is to end.
void come_again(Scene& scene, const WayCome& way) {
  const World& world = scene.world();
  Headway headway(world);
  while (world.steps < way.steps) {
    if (scripts_interrupted()) throw Interrupted(text("stopped at ", world.time, " s, on the way to the saved state"));
    require(world.time < way.time, "it is to be of ", way.time, " s, and does not take ", way.steps, " steps to there");
    scene.step();
    require(world.failure.empty(), world.failure);
    headway.check(world, way.time);
  }
  require(state_hash(world) == way.hash, "it did not come to the same state again");
}

std::unique_ptr<Scene> scene_again(Reader& from, const SceneOptions& given) {
  Script sources(given);
  visit_sources(from, sources);
  WayCome way;
  visit(from, way);
  read_kept_files_first(sources);
  SceneOptions options = given;
  options.set = sources.options.set;
  options.read = sources.runtime.reader;
  options.save = [](const std::string&, const std::string&) {};  // it was written the first time
  const Runtime& runtime = sources.runtime;
  require(runtime.chunks.size() > 1, "its script is missing");
  auto scene = open_scene_text(runtime.chunks[1].source, runtime.name, runtime.folder, options);
  come_again(*scene, way);
  script_of(*scene).options.save = given.save;
  return scene;
}

std::unique_ptr<Scene> scene_from(std::string_view body, const SceneOptions& options) {
  const Outside outside;
  Reader from(body);
  bool again = false;
  visit(from, again);
  return again ? scene_again(from, options) : scene_with(from, options);
}

/// Whether the script waits in a play: what it keeps there Lua does not tell. Throws Error where it could not do the same
/// again, as hands may have been at work.
bool goes_again(const Script& script) {
  const std::string why = why_not_restore(script.world);
  if (why.empty()) return false;
  require(!script.options.changing, "save: ", why.substr(0, why.find("), which")),
          "), which only a scene that is run without a window can be saved with");
  return true;
}

}  // namespace

std::string state_of(Script& script) {
  require(script.world.failure.empty(), "save: the scene has failed: ", script.world.failure);
  Writer to;
  bool again = goes_again(script);
  visit(to, again);
  visit_sources(to, script);
  if (!again) renew_laws(script.world, script.laws);
  WayCome way{script.world.steps, script.world.time, state_hash(script.world)};
  try {
    if (again)
      visit(to, way);
    else
      script.runtime.run([&](lua_State* state) { write_all(state, script, to); });
  } catch (const Interrupted&) { throw; } catch (const Error& error) {
    throw Error(text("save: ", error.what()));
  }
  FileHead head{{}, layout_of_state(), to.bytes.size(), 0};
  std::memcpy(head.magic, magic.data(), sizeof head.magic);
  head.hash = hash_of(head, to.bytes);
  return std::string(reinterpret_cast<const char*>(&head), sizeof head) + to.bytes;
}

void save_wanted(Script& script) {
  if (script.save_as.empty()) return;
  const std::string name = std::exchange(script.save_as, "");
  try {
    script.options.save(name, state_of(script));
  } catch (const Interrupted&) { throw; } catch (const Error& error) {
    throw ScriptError(text(script.saves_at, ": ", error.what()));
  }
}

bool is_state(const std::string& bytes) { return bytes.starts_with(magic); }

std::unique_ptr<Scene> open_state(const std::string& bytes, const std::string& name, const SceneOptions& options) {
  const auto check = [&](bool good, const char* why) {
    if (!good) throw UsageError(text(name, ": ", why));
  };
  FileHead head{};
  const std::size_t start = std::min(bytes.size(), sizeof head.magic);
  check(start > 0 && std::memcmp(bytes.data(), magic.data(), start) == 0, "this is no state that Pantin saved");
  check(bytes.size() >= sizeof head, "the state is cut off");
  std::memcpy(&head, bytes.data(), sizeof head);
  const std::string_view body = std::string_view(bytes).substr(sizeof head);
  check(body.size() >= head.size, "the state is cut off");
  check(body.size() == head.size && head.hash == hash_of(head, body), "the state is damaged: its checksum is wrong");
  check(head.layout == layout_of_state(),
        "the state was saved by another version of Pantin, and only that can go on from it");
  try {
    return scene_from(body, options);
  } catch (const Interrupted&) { throw; } catch (const Error& error) {
    throw UsageError(text(name, ": the state cannot be read: ", error.what()));
  }
}

}  // namespace pantin::lua
