#include "lua/scene/sounds.hpp"

#include <algorithm>
#include <cmath>

#include "lua/thing/fields.hpp"
#include "lua/value/arguments.hpp"
#include "lua/vm/runtime.hpp"
#include "scene/files.hpp"

namespace pantin::lua {
namespace {

constexpr double lowest_pitch = 0.125, highest_pitch = 8.0;
constexpr double usual_mass = 1.0;    // [kg] of what sounds at the usual pitch
constexpr double full_speed = 6.0;    // [m/s] by which a stroke changes what is heard at full volume
constexpr double least_speed = 0.05;  // [m/s]

void add_sound(Script& script, SoundCall call) {
  if (script.sounds.size() < most_sounds) script.sounds.push_back(std::move(call));
}

struct Struck {
  double mass = infinity;  // [kg]
  double density = 0.0;    // [kg/m³]
};

Struck struck(const World& world, const AnyId& thing) {
  if (const auto* body = std::get_if<BodyId>(&thing); body && world.bodies.alive(*body)) {
    const auto& shapes = world.bodies[*body].shapes;
    return {world.motion_of(*body).mass, shapes.empty() ? 0.0 : world.shapes[shapes[0]].material.density};
  }
  if (const auto* particle = std::get_if<ParticleId>(&thing); particle && world.particles.alive(*particle))
    return {mass(world, *particle), 0.0};
  return {};
}

/// As what has this density often sounds.
SoundKind sound_of_density(double density) {
  if (density < 1050.0) return SoundKind::wood;
  if (density < 2000.0) return SoundKind::rubber;
  return density < 4500.0 ? SoundKind::glass : SoundKind::metal;
}

}  // namespace

std::string check_sound(lua_State* state, int index, const char* call, const char* name) {
  const std::string sound = check_text(state, index, call, name);
  if (sound_kind(sound)) return sound;
  const std::vector<std::string> names(sound_names.begin(), sound_names.end());
  require(sound.ends_with(".wav"), call, ": ", name, ": there is no sound '", sound, "'.", suggestion(sound, names),
          " There are ", joined(names), ", and .wav files of the scene's folder");
  Runtime& runtime = Runtime::of(state);
  const std::string path = path_in(runtime.folder, sound);
  require(stays_inside(sound) && lies_below(path, runtime.folder), call, ": '", sound,
          "' must be a file below the scene's folder");
  if (!runtime.files.contains(path))
    require(runtime.read(path, largest_file) != nullptr, call, ": there is no file '", path, "'");
  return path;
}

int scene_sound(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "sound");
  SoundCall call;
  call.name = check_sound(state, 2, "sound", "argument 1, the sound,");
  const Options o(state, 3, "sound", {"volume", "pitch"});
  call.volume = o.number("volume", "").value_or(1.0);
  call.pitch = o.number("pitch", "").value_or(1.0);
  require(call.volume >= 0.0 && call.volume <= 1.0, "sound: volume must be from 0 to 1, got ", call.volume);
  require(call.pitch >= lowest_pitch && call.pitch <= highest_pitch, "sound: pitch must be from ", lowest_pitch, " to ",
          highest_pitch, ", got ", call.pitch);
  add_sound(self.script, std::move(call));
  return 0;
}

/// As loud as the stroke changes the speed of the lighter one, as high as that is light.
void sound_touch(Script& script, const Touch& touch) {
  if (script.contact_sounds.empty()) return;
  const Struck a = struck(script.world, touch.pair.a), b = struck(script.world, touch.pair.b);
  const Struck& lighter = a.mass <= b.mass ? a : b;
  const double speed = touch.impulse / lighter.mass;
  if (!(speed > least_speed)) return;
  SoundCall call;
  const SoundKind kind = sound_of_density(lighter.density);
  call.name = script.contact_sounds == by_material ? std::string(sound_names[static_cast<std::size_t>(kind)])
                                                   : script.contact_sounds;
  call.volume = std::min(1.0, speed / full_speed);
  call.pitch = std::clamp(std::cbrt(usual_mass / lighter.mass), 0.5, 4.0);
  add_sound(script, std::move(call));
}

}  // namespace pantin::lua
