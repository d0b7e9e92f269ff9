#include "lua/scene/scene_settings.hpp"

#include "lua/scene/scene_type.hpp"
#include "lua/thing/script.hpp"
#include "lua/thing/targets.hpp"
#include "lua/value/arguments.hpp"
#include "lua/vm/guard.hpp"

namespace pantin::lua {
namespace {

constexpr double longest_history = 60.0;  // [s] of states in memory

double check_positive(const Self& s, int index, const char* name, const char* unit) {
  const double value = check_number(s.state, index, "scene", name, unit);
  require(value > 0, "scene: ", name, " must be > 0", *unit ? " " : "", unit, ", got ", value);
  return value;
}

void write_camera(const Self& s, int index) {
  require(lua_istable(s.state, index), "scene: camera must be a table { at, look_at, follow }, got ",
          kind_of_value(s.state, index));
  const Options o(s.state, index, "scene: camera", {"at", "look_at", "follow"});
  const auto at = o.vector("at", "m"), look_at = o.vector("look_at", "m");
  AnyId follow;
  if (o.has("follow")) {
    const Ref& ref = check_thing(s.state, o.push("follow"), "scene: camera", "follow");
    follow = ref.thing;
    lua_pop(s.state, 1);
  }
  s.script.camera_at = at;
  s.script.camera_look_at = look_at;
  s.script.camera_follow = follow;
}

void read_camera(const Self& s) {
  lua_newtable(s.state);
  const auto set = [&](const char* name, const std::optional<Vec3>& v) {
    if (!v) return;
    push(s.state, *v);
    lua_setfield(s.state, -2, name);
  };
  set("at", s.script.camera_at);
  set("look_at", s.script.camera_look_at);
  push_thing(s.state, s.script, s.script.camera_follow);
  lua_setfield(s.state, -2, "follow");
}

}  // namespace

std::vector<Field> show_settings() {
  return {
      {"title", "string", "", "what the window and the pictures are called (default the file's name)",
       [](const Self& s) { lua_pushstring(s.state, s.script.title.c_str()); },
       [](const Self& s, int i) { s.script.title = check_text(s.state, i, "scene", "title"); }},
      {"duration", "number?", "s", "end of a headless run (default none, which ends after 10 s)",
       [](const Self& s) {
         if (s.script.duration)
           lua_pushnumber(s.state, *s.script.duration);
         else
           lua_pushnil(s.state);
       },
       [](const Self& s, int i) { s.script.duration = check_positive(s, i, "duration", "s"); }},
      {"pace", "number", "1", "simulated s per real s (default `1`)",
       [](const Self& s) { lua_pushnumber(s.state, s.script.pace); },
       [](const Self& s, int i) { s.script.pace = check_positive(s, i, "pace", ""); }},
      {"history", "number", "s",
       "for how long the states of all steps are kept, for `scene:rewind` (default `0`, none)",
       [](const Self& s) { lua_pushnumber(s.state, s.script.history); },
       [](const Self& s, int i) {
         const double value = check_number(s.state, i, "scene", "history", "s");
         require(value >= 0.0 && value <= longest_history, "scene: history must be from 0 to ", longest_history,
                 " s, got ", value);
         s.script.history = value;
       }},
      {"camera", "Camera", "", "where the scene is seen from (default from where all is seen)", read_camera,
       write_camera},
      {"store", "table", "", "plain values of yours, which snapshots keep (default `{}`)",
       [](const Self& s) { push_store(s.state, s.script); },
       [](const Self& s, int i) {
         require(lua_istable(s.state, i), "scene: store must be a table, got ", kind_of_value(s.state, i));
         lua_pushvalue(s.state, i);
         lua_rawsetp(s.state, LUA_REGISTRYINDEX, &s.script.keys[kind_count + 1]);
       }},
  };
}

}  // namespace pantin::lua
