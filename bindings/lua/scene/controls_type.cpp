// `scene.keys` and `scene.pad`: what is held of keys and of a gamepad.
#include "lua/law/law_run.hpp"
#include "lua/scene/events.hpp"
#include "lua/thing/fields.hpp"
#include "lua/thing/script.hpp"
#include "lua/value/arguments.hpp"
#include "scene/controls.hpp"

namespace pantin::lua {
namespace {

/// What is read is the scene's from then on.
double held(const Self& self, const std::string& control) {
  if (LawRun* law = Runtime::of(self.state).law) law->mistake(self.state, "a law cannot read what is held of keys");
  self.script.controls.insert(control);
  const auto found = self.world.controls.find(control);
  return found == self.world.controls.end() ? 0.0 : found->second;
}

bool read_key(const Self& self, const char* name) {
  lua_pushboolean(self.state, held(self, check_control(name)) != 0.0);
  return true;
}

bool read_pad(const Self& self, const char* name) {
  const std::string control = check_control(std::string(pad_prefix) + name);
  const double value = held(self, control);
  if (pad_control(name)->axis)
    lua_pushnumber(self.state, value);
  else
    lua_pushboolean(self.state, value != 0.0);
  return true;
}

std::string check_one_key(const std::string& name) {
  const auto key = key_named(name);
  const auto words = key_words();
  require(key.has_value(), "keys: there is no key '", name, "'.",
          suggestion(name, std::vector<std::string>(words.begin(), words.end())),
          " There are letters and digits as they stand on a keyboard, ",
          joined(std::vector<std::string>(words.begin(), words.end())));
  return *key;
}

}  // namespace

std::string check_control(const std::string& name) {
  if (name.starts_with(pad_prefix)) {
    const std::string own = name.substr(pad_prefix.size());
    std::vector<std::string> names;
    for (const PadControl& control : pad_controls()) names.emplace_back(control.name);
    require(pad_control(own) != nullptr, "pad: unknown '", own, "'.", suggestion(own, names), " There are ",
            joined(names));
    return name;
  }
  return check_one_key(name);
}

std::string check_key(const std::string& name) {
  for (const std::string modifiers : {"ctrl+shift+", "ctrl+"})
    if (name.starts_with(modifiers)) return modifiers + check_one_key(name.substr(modifiers.size()));
  return check_one_key(name);
}

const Type& held_keys_type() {
  static const Type type = [] {
    Type made{
        "HeldKeys",
        "keys",
        "What keys are held, by their names: `scene.keys.left`, `scene.keys.a`, `scene.keys.left_shift`. A key that "
        "a script reads is the scene's and not the window's from then on, so read it once where the file begins if "
        "that matters; Esc never is. Without a window none is "
        "held, unless a test or a recording holds it.",
        {},
        {}};
    made.more = read_key;
    made.more_doc = "boolean whether this key is held";
    return made;
  }();
  return type;
}

const Type& gamepad_type() {
  static const Type type = [] {
    Type made{
        "Gamepad",
        "pad",
        "What is held of a gamepad: `left_x left_y right_x right_y` (-1 to 1, right and up > 0), `left_trigger "
        "right_trigger` (0 to 1); `a b x y left_shoulder right_shoulder left_stick right_stick start back up down "
        "left right` (true while held). Of several gamepads that which is pressed most counts, and with none all "
        "is at rest. What a script reads is the scene's: a stick of which it reads an axis is no hand. When one is "
        "pressed "
        "`scene:on(\"key\", \"pad.a\", f)` tells.",
        {},
        {}};
    made.more = read_pad;
    made.more_doc = "number|boolean [1] of an axis or a button";
    return made;
  }();
  return type;
}

}  // namespace pantin::lua
