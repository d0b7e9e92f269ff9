// A scene that a test opened.
#include <algorithm>

#include "lua/scene/events.hpp"
#include "lua/scene/parameters.hpp"
#include "lua/scene/script_scene.hpp"
#include "lua/scene/snapshot.hpp"
#include "lua/thing/fields.hpp"
#include "lua/thing/script.hpp"
#include "lua/value/arguments.hpp"
#include "lua/vm/guard.hpp"
#include "scene/controls.hpp"
#include "scene/headway.hpp"

namespace pantin::lua {
namespace {

void step_once(Script& script) {
  const Outside outside;
  step_scene(script);
  require(script.world.failure.empty(), script.world.failure);
}

int step_opened(lua_State* state) {
  step_once(check_self(state, Kind::scene, "step").script);
  return 0;
}

int advance_opened(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "advance");
  const double seconds = check_number(state, 2, "advance", "argument 1, the time,", "s");
  require(seconds >= 0, "advance: argument 1, the time, must be >= 0 s, got ", seconds);
  const double until = self.world.time + seconds;
  Headway headway(self.world);
  while (self.world.time < until - 0.5 * self.world.settings.step) {
    step_once(self.script);
    headway.check(self.world, until);
  }
  return 0;
}

/// Of the key at argument 1.
Command control_at(lua_State* state, const char* call) {
  Command command;
  command.kind = Command::Kind::control;
  command.name = check_control(check_text(state, 2, call, "argument 1, the key,"));
  return command;
}

/// How far it is held once what waits for the next step is done.
double held(const World& world, const std::string& name) {
  const std::vector<Command>& waiting = world.input.commands;
  const auto last = std::find_if(waiting.rbegin(), waiting.rend(),
                                 [&](const Command& c) { return c.kind == Command::Kind::control && c.name == name; });
  if (last != waiting.rend()) return last->value;
  const auto known = world.controls.find(name);
  return known == world.controls.end() ? 0.0 : known->second;
}

/// What is pressed that was not is told, too.
int hold_control(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "hold");
  Command command = control_at(state, "hold");
  command.value = lua_isnoneornil(state, 3) ? 1.0 : check_number(state, 3, "hold", "argument 2, how far,", "");
  require(command.value >= -1.0 && command.value <= 1.0, "hold: argument 2, how far, must be from -1 to 1, got ",
          command.value);
  const bool is_pressed = command.value != 0.0 && held(self.world, command.name) == 0.0;
  std::vector<Command>& commands = self.world.input.commands;
  commands.push_back(command);
  command.kind = Command::Kind::key;
  command.value = 0.0;
  if (is_pressed) commands.push_back(command);
  return 0;
}

int release_control(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "release");
  self.world.input.commands.push_back(control_at(state, "release"));
  return 0;
}

int press_button(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "press");
  Command command;
  command.kind = Command::Kind::button;
  command.name = check_text(state, 2, "press", "argument 1, the button,");
  const std::vector<std::string>& names = self.script.buttons;
  require(std::find(names.begin(), names.end(), command.name) != names.end(), "press: there is no button '",
          command.name, "'.", suggestion(command.name, names), " There ",
          names.empty() ? "are none" : "are: " + joined(names));
  self.world.input.commands.push_back(command);
  return 0;
}

int point_mouse(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "mouse");
  const Options o(state, 2, "mouse", {"at", "left", "middle", "right", "wheel"});
  Command command;
  command.kind = Command::Kind::mouse;
  const std::optional<Vec3> at = o.vector("at", "m");
  command.position = at ? *at : self.world.mouse.position.value_or(zero3());
  command.value = o.number("wheel", "notches").value_or(0.0);
  for (const char* button : {"left", "middle", "right"})
    if (o.boolean(button).value_or(false)) command.name += text(command.name.empty() ? "" : " ", button);
  self.world.input.commands.push_back(command);
  return 0;
}

int read_probe(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "read");
  const std::string name = check_text(state, 2, "read", "argument 1, the probe,");
  std::vector<std::string> names;
  for (const Probe& probe : self.world.probes) {
    names.push_back(probe.name);
    if (probe.name != name) continue;
    const Outside outside;
    lua_pushnumber(state, probe.read());
    return 1;
  }
  throw Error(text("read: there is no probe '", name, "'.", suggestion(name, names), " There are: ", joined(names)));
}

int read_result(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "result");
  const std::string name = check_text(state, 2, "result", "argument 1, the name,");
  const auto found = self.script.results.find(name);
  require(found != self.script.results.end(), "result: there is no result '", name, "'");
  push_value(state, found->second);
  return 1;
}

int restore_opened(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "restore");
  const std::shared_ptr<const ScriptSnapshot> snapshot = check_snapshot(state, 2, self.script);
  const Outside outside;
  restore(self.script, *snapshot);
  return 0;
}

void push_next_parameters(const Self& s) {
  lua_newtable(s.state);
  for (const auto& [name, value] : s.script.next.parameters) {
    push_value(s.state, value);
    lua_setfield(s.state, -2, name.c_str());
  }
}

Type make() {
  Type type{"OpenedScene", "opened scene", "A scene that a test opened.", {}, {}};
  type.fields.push_back({"finished", "boolean", "", "whether it called scene:finish()",
                         [](const Self& s) { lua_pushboolean(s.state, s.script.finished); }, nullptr});
  type.fields.push_back(
      {"drawn", "integer", "", "lines, arrows, texts and points that it drew in the last step",
       [](const Self& s) { lua_pushinteger(s.state, static_cast<lua_Integer>(s.script.drawings.size())); }, nullptr});
  type.fields.push_back({"sounds", "string[]", "", "names of the sounds that began in the last step",
                         [](const Self& s) {
                           lua_newtable(s.state);
                           for (std::size_t i = 0; i < s.script.sounds.size(); i++) {
                             lua_pushstring(s.state, s.script.sounds[i].name.c_str());
                             lua_rawseti(s.state, -2, static_cast<lua_Integer>(i + 1));
                           }
                         },
                         nullptr});
  type.fields.push_back({"taken", "string", "",
                         "keys and what of gamepads and the mouse it has read, which are its own",
                         [](const Self& s) {
                           const std::vector<std::string> names(s.script.controls.begin(), s.script.controls.end());
                           lua_pushstring(s.state, joined(names).c_str());
                         },
                         nullptr});
  type.fields.push_back({"next", "string?", "", "the file that it opened by scene:open",
                         [](const Self& s) {
                           if (s.script.next.path.empty())
                             lua_pushnil(s.state);
                           else
                             lua_pushstring(s.state, s.script.next.path.c_str());
                         },
                         nullptr});
  type.fields.push_back(
      {"next_parameters", "table", "", "the parameters that it opened that file with", push_next_parameters, nullptr});
  type.fields.push_back({"saved", "Saved", "", "what it keeps for the next time, to be read and written",
                         [](const Self& s) { push_ref(s.state, make_ref(s.script, Kind::saved, 1, 1, 1)); }, nullptr});
  type.methods = {
      {"advance", guard<advance_opened>, "seconds: number [s]", "", "Steps on for a time.", "opened:advance(0.5)"},
      {"step", guard<step_opened>, "", "", "Does one step.", "opened:step()"},
      {"hold", guard<hold_control>, "key: string, how_far?: number [1]", "",
       "Presses a key from the next step on until it is released; or, by a name as \"pad.left_x\", what a gamepad has, "
       "as far as is said (-1 to 1, default 1).",
       "opened:hold(\"left\")\n"
       "opened:hold(\"pad.left_x\", -0.5)"},
      {"release", guard<release_control>, "key: string", "", "Lets go of what is held.",
       "opened:hold(\"space\")\n"
       "opened:advance(0.1)\n"
       "opened:release(\"space\")"},
      {"press", guard<press_button>, "button: string", "", "Presses a button of scene:button, in the next step.",
       "local game = open_text [[ scene:button(\"start\", function() scene:finish() end) ]]\n"
       "game:press(\"start\")\n"
       "game:step()"},
      {"mouse", guard<point_mouse>, "options?: MouseOptions", "",
       "Points with the mouse from the next step on, until the next call.",
       "opened:mouse { at = vec(1, 2, 0), left = true }\n"
       "opened:advance(0.1)\n"
       "opened:mouse()"},
      {"read", guard<read_probe>, "name: string", "number", "The present number of a probe.",
       "expect(opened:read(\"height\")):near(1, 1e-9)"},
      {"result", guard<read_result>, "name: string", "number|boolean|string", "A result that the scene gave.",
       "expect(opened:result(\"answer\")):equal(42)"},
      {"snapshot", guard<scene_snapshot>, "", "Snapshot", "The present state.", "local before = opened:snapshot()"},
      {"restore", guard<restore_opened>, "snapshot: Snapshot", "", "Puts a state back.",
       "local before = opened:snapshot()\n"
       "opened:advance(0.1)\n"
       "opened:restore(before)"},
  };
  add_base(type, any_scene_type());
  type.methods.insert(type.methods.end(), any_scene_type().methods.begin(), any_scene_type().methods.end());
  return type;
}

}  // namespace

const Type& type_of_opened_scene() {
  static const Type type = make();
  return type;
}

}  // namespace pantin::lua
