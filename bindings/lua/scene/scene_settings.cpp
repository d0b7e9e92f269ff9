#include "lua/scene/scene_settings.hpp"

#include "lua/scene/scene_type.hpp"
#include "lua/scene/sounds.hpp"
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

void read_contact_sounds(const Self& s) {
  const std::string& how = s.script.contact_sounds;
  if (how.empty() || how == by_material)
    lua_pushboolean(s.state, !how.empty());
  else
    lua_pushstring(s.state, how.c_str());
}

void write_contact_sounds(const Self& s, int index) {
  if (lua_isboolean(s.state, index))
    s.script.contact_sounds = lua_toboolean(s.state, index) ? by_material : "";
  else
    s.script.contact_sounds = check_sound(s.state, index, "scene", "contact_sounds");
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
       [](const Self& s, int i) {
         s.script.duration.reset();
         if (!lua_isnil(s.state, i)) s.script.duration = check_positive(s, i, "duration", "s");
       }},
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
      {"camera", "Camera", "", "where the scene is seen from (default from where all is seen)",
       [](const Self& s) { push_ref(s.state, make_ref(s.script, Kind::camera, 1, 1, 1)); }, write_camera},
      {"dark", "boolean", "", "whether it is shown on a dark ground, as what glows wants it (default `false`)",
       [](const Self& s) { lua_pushboolean(s.state, s.script.dark); },
       [](const Self& s, int i) {
         require(lua_isboolean(s.state, i), "scene: dark must be a boolean, got ", kind_of_value(s.state, i));
         s.script.dark = lua_toboolean(s.state, i) != 0;
       }},
      {"saved", "Saved", "", "plain values of yours, which last from one play to the next",
       [](const Self& s) { push_ref(s.state, make_ref(s.script, Kind::saved, 1, 1, 1)); }, nullptr},
      {"contact_sounds", "boolean|string", "",
       "whether what touches is heard, as hard as it strikes: as its density says (wood, rubber, glass or metal) where "
       "it is true, else as the sound of this name (default `false`)",
       read_contact_sounds, write_contact_sounds},
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
