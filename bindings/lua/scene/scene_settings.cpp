#include "lua/scene/scene_settings.hpp"

#include <algorithm>
#include <cmath>

#include "edit/edit.hpp"
#include "lua/scene/scene_type.hpp"
#include "lua/thing/script.hpp"
#include "lua/thing/targets.hpp"
#include "lua/value/arguments.hpp"
#include "lua/vm/guard.hpp"

namespace pantin::lua {
namespace {

double check_positive(const Self& s, int index, const char* name, const char* unit) {
  const double value = check_number(s.state, index, "scene", name, unit);
  require(value > 0, "scene: ", name, " must be > 0", *unit ? " " : "", unit, ", got ", value);
  return value;
}

void require_unlocked(const Self& s, const char* name) {
  require(!s.world.locked, "scene: ", name,
          " cannot be written while the world steps; write it in an event or a step callback");
}

void write_camera(const Self& s, int index) {
  require(lua_istable(s.state, index), "scene: camera must be a table { at, look_at, follow }, got ",
          kind_of_value(s.state, index));
  const Options o(s.state, index, "scene: camera", {"at", "look_at", "follow"});
  const auto at = o.vector("at", "m"), look_at = o.vector("look_at", "m");
  AnyId follow;
  if (o.has("follow")) {
    const Ref& ref = check_thing(s.state, o.push("follow"), "scene: camera", "follow");
    follow = any_of(ref);
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

void write_integrator(const Self& s, int index) {
  const std::string name = check_text(s.state, index, "scene", "integrator");
  std::string known;
  for (const NamedIntegrator& named : integrators) {
    if (named.name == name) return set_integrator(s.world, named.integrator);
    known += text(known.empty() ? "\"" : named.name == integrators.back().name ? " or \"" : ", \"", named.name, "\"");
  }
  throw Error(text("scene: integrator must be ", known, ", got \"", name, "\""));
}

void read_plane(const Self& s) {
  if (!s.world.plane.flat()) return lua_pushnil(s.state);
  const std::string_view name = plane_names[static_cast<std::size_t>(s.world.plane.normal)];
  lua_pushlstring(s.state, name.data(), name.size());
}

void write_plane(const Self& s, int index) {
  if (lua_isnil(s.state, index)) return set_plane(s.world, {});
  const std::string name = check_text(s.state, index, "scene", "plane");
  const auto found = std::find(plane_names.begin(), plane_names.end(), name);
  require(found != plane_names.end(), "scene: plane must be \"xy\", \"xz\" or \"yz\", got \"", name, "\"");
  set_plane(s.world, {static_cast<int>(found - plane_names.begin())});
}

void write_seed(const Self& s, int index) {
  const double seed = check_number(s.state, index, "scene", "seed", "");
  require(seed >= 0 && seed < 0x1p53 && std::trunc(seed) == seed,
          "scene: seed must be a whole number from 0 to 2^53, got ", seed);
  s.world.settings.seed = static_cast<std::uint64_t>(seed);
  s.world.random = Random{s.world.settings.seed, 0};
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

std::vector<Field> engine_settings() {
  return {
      {"gravity", "vec", "m/s²", "uniform acceleration (default `vec(0, -9.81, 0)`)",
       [](const Self& s) { push(s.state, s.world.settings.gravity); },
       [](const Self& s, int i) { set_gravity(s.world, check_vec(s.state, i, "scene", "gravity", "m/s²")); }},
      {"step", "number", "s", "length of one step (default `1 / 240`)",
       [](const Self& s) { lua_pushnumber(s.state, s.world.settings.step); },
       [](const Self& s, int i) { set_step(s.world, check_positive(s, i, "step", "s")); }},
      {"accuracy", "number?", "1/s",
       "wanted error per second, relative to the distance between what interacts, or to how far it swings beside a "
       "uniform motion where it interacts with nothing; sub-steps follow from it. Functions of time that ties follow "
       "are then asked at each quarter of a step (default none: fixed steps)",
       [](const Self& s) {
         if (s.world.settings.accuracy)
           lua_pushnumber(s.state, *s.world.settings.accuracy);
         else
           lua_pushnil(s.state);
       },
       [](const Self& s, int i) {
         set_accuracy(s.world,
                      lua_isnil(s.state, i) ? std::optional<double>() : check_positive(s, i, "accuracy", "1/s"));
       }},
      {"accuracy_per", "string", "",
       "whether `accuracy` is that of a \"second\" or of a \"step\", as where a scene lasts microseconds (default "
       "`\"second\"`)",
       [](const Self& s) { lua_pushstring(s.state, s.world.settings.accuracy_per_step ? "step" : "second"); },
       [](const Self& s, int i) {
         const std::string per = check_text(s.state, i, "scene", "accuracy_per");
         require(per == "second" || per == "step", "scene: accuracy_per must be \"second\" or \"step\", got \"", per,
                 "\"");
         set_accuracy_per_step(s.world, per == "step");
       }},
      {"integrator", "string", "",
       "\"verlet\" (2nd order), \"implicit\" (the same with connections of any stiffness), \"suzuki4\" (4th order, "
       "where "
       "nothing dissipates), \"rk4\" (4th order, no constraints), \"euler\" (1st order, semi-implicit; free particles "
       "as with "
       "\"verlet\") (default `\"verlet\"`)",
       [](const Self& s) {
         const std::string_view name = name_of(s.world.settings.integrator);
         lua_pushlstring(s.state, name.data(), name.size());
       },
       write_integrator},
      {"energy_return", "boolean", "", "give back what the velocity projection took (default `true`)",
       [](const Self& s) { lua_pushboolean(s.state, s.world.settings.energy_return); },
       [](const Self& s, int i) {
         require_unlocked(s, "energy_return");
         s.world.settings.energy_return = check_boolean(s.state, i, "scene", "energy_return");
       }},
      {"box", "vec?", "m", "edges of the periodic box (default none: open space)",
       [](const Self& s) {
         if (s.world.settings.box)
           push(s.state, *s.world.settings.box);
         else
           lua_pushnil(s.state);
       },
       [](const Self& s, int i) {
         std::optional<Vec3> box;
         if (!lua_isnil(s.state, i)) box = check_vec(s.state, i, "scene", "box", "m");
         set_box(s.world, box);
       }},
      {"plane", "string?", "",
       "\"xy\", \"xz\" or \"yz\": everything stays in that plane, and forces across it do nothing; set it before "
       "things "
       "are made (default none: in space)",
       read_plane, write_plane},
      {"tolerance", "number", "1",
       "points of a new hinge may be this far apart, relative to the size of their bodies (default `1e-6`)",
       [](const Self& s) { lua_pushnumber(s.state, s.world.settings.tolerance); },
       [](const Self& s, int i) { s.world.settings.tolerance = check_positive(s, i, "tolerance", ""); }},
      {"seed", "integer", "", "of math.random (default `1`)",
       [](const Self& s) { lua_pushinteger(s.state, static_cast<lua_Integer>(s.world.settings.seed)); }, write_seed},
      {"boltzmann", "number", "J/K", "k_B; temperature is in J while it is 1 (default `1`)",
       [](const Self& s) { lua_pushnumber(s.state, s.world.settings.boltzmann); },
       [](const Self& s, int i) { s.world.settings.boltzmann = check_positive(s, i, "boltzmann", "J/K"); }},
  };
}

}  // namespace pantin::lua
