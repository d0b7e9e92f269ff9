#include "view/keys.hpp"

#include <algorithm>
#include <iterator>

#include "base/check.hpp"
#include "view/views.hpp"

namespace pantin {

namespace {

using Use = KeyUse;

std::vector<WindowKeys> keys_of_hands() {
  constexpr std::optional play = KeyPlace::play;
  return {
      {"Hands",
       Use::told,
       {},
       "left drag",
       "use the tool: pull a point, and throw it (shift: select; make on a grid)",
       0,
       play},
      {"Hands",
       Use::tool,
       {"1", "2", "3", "4", "5", "6", "7", "8", "9"},
       "1 … 9",
       "drag, cut, join, nail, push, spin, remove, make, heat",
       0,
       play},
      {"Hands", Use::tool_before, {"["}, "[", "the tool before", 0, play},
      {"Hands", Use::tool_next, {"]"}, "]", "the next tool", 0, play},
      {"Hands", Use::cut, {"x"}, "x, ctrl + click", "cut what is under the pointer", 0, play},
      {"Hands",
       Use::whole,
       {"ctrl+c", "ctrl+v", "ctrl+m", "delete"},
       "ctrl + c, v, m, delete",
       "copy, paste, paste mirrored, remove: with all that is joined",
       0,
       play},
      {"Hands", Use::undo, {"ctrl+z"}, "ctrl + z", "undo", 0, play},
      {"Hands", Use::redo, {"ctrl+shift+z", "ctrl+y"}, "ctrl + shift + z", "redo", 0, play},
      {"Hands", Use::told, {}, "fingers, sticks", "each is a hand; two move the view", 0, play},
      {"Hands",
       Use::told,
       {"left", "right", "up", "down", "return", "keypad enter", "keypad 2", "keypad 4", "keypad 5", "keypad 6",
        "keypad 8"},
       "arrows, enter",
       "a second hand (shift: slow)",
       0,
       play},
  };
}

std::vector<WindowKeys> keys_of_window() {
  constexpr std::optional play = KeyPlace::play, replay = KeyPlace::replay;
  return {
      {"Time", Use::pause, {"space"}, "space", "pause, run", 0, play},
      {"Time", Use::pause, {"space"}, "space", "pause, run; at the end of a recording: from its start", 0, replay},
      {"Time", Use::step, {"."}, ".", "one step"},
      {"Time", Use::step_back, {","}, ",", "one step back, in a recording", 0, replay},
      {"Time", Use::slower, {"-", "keypad -"}, "-", "slower"},
      {"Time", Use::faster, {"=", "+", "keypad +"}, "+", "faster"},
      {"Time", Use::own_pace, {"0"}, "0", "the scene's own pace"},
      {"Time", Use::restart, {"r"}, "r", "restart", 0, play},
      {"Time", Use::restart, {"r"}, "r", "to the start of a recording", 0, replay},
      {"Window", Use::scenes, {"n"}, "n", "all scenes", 0, play},
      {"Window", Use::scene_before, {"pageup"}, "page up", "the scene before", 0, play},
      {"Window", Use::scene_next, {"pagedown"}, "page down", "the next scene", 0, play},
      {"Window",
       Use::panel,
       {"F1", "F2", "F3", "F4", "F5", "F6", "F7", "F8"},
       "F1 … F8",
       "panels: parameters, time, probes, energy, solver, phases, log, thing",
       0,
       play},
      {"Window", Use::panels, {"tab"}, "tab", "hide all but the scene, show it", 0, play},
      {"Window", Use::fullscreen, {"F11"}, "F11", "the whole screen, or a window"},
      {"Window", Use::picture, {"s"}, "s", "take a picture", 0, play},
      {"Window", Use::film, {"F9"}, "F9", "film the scene, until it is pressed again", 0, play},
      {"Window",
       Use::save_state,
       {"ctrl+s"},
       "ctrl + s",
       "save the state into a file, for `pantin play FILE`",
       0,
       play},
      {"Window",
       Use::save_scene,
       {"ctrl+shift+s"},
       "ctrl + shift + s",
       "save what was built, as a scene in Lua",
       0,
       play},
      {"Window", Use::open_state, {"ctrl+o"}, "ctrl + o", "open the state that was saved last", 0, play},
      {"Window", Use::help, {"h"}, "h", "show or hide the keys"},
      {"Window",
       Use::leave,
       {"escape", "q"},
       "Esc, q",
       "leave; Esc first lets go, and closes what was opened",
       0,
       play},
      {"Window", Use::leave, {"escape", "q"}, "Esc, q", "quit, in a recording", 0, replay},
      {"View", Use::told, {}, "right drag", "turn the view"},
      {"View", Use::told, {}, "middle drag", "shift the view (or shift + right); the wheel zooms"},
      {"View", Use::told, {}, "double click", "follow a thing; beside all, none", 0, play},
      {"View", Use::see_all, {"f"}, "f", "see what plays; again: also what is far away"},
      {"View", Use::see_start, {"home"}, "home", "as the scene began", 0, play},
      {"View", Use::see_freely, {"u"}, "u", "in perspective"},
      {"View", Use::see_front, {"i"}, "i", "from the front, without perspective"},
      {"View", Use::see_right, {"o"}, "o", "from the right side"},
      {"View", Use::see_top, {"p"}, "p", "from the top"},
  };
}

void add_views(std::vector<WindowKeys>& table) {
  constexpr std::pair<View, const char*> keys[] = {
      {View::bodies, "b"},      {View::loads, "c"},      {View::shadows, "l"},        {View::rings, "g"},
      {View::forces, "a"},      {View::velocities, "v"}, {View::trails, "w"},         {View::families, "m"},
      {View::articulates, "y"}, {View::islands, ";"},    {View::temperature, "t"},    {View::errors, "e"},
      {View::cells, "k"},       {View::contacts, "z"},   {View::contact_forces, "/"}, {View::asleep, "'"},
      {View::dark, "d"},
  };
  for (const auto& [shown, key] : keys) {
    const auto place = static_cast<std::size_t>(shown);
    const NamedView& named = view_table()[place];
    const bool says = std::string_view(named.help).starts_with(named.name);
    table.push_back({"View", Use::view, {key}, key, says ? named.help : text(named.name, ": ", named.help), place});
  }
}

/// Those of functions are written in capitals.
bool same_key(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
  return std::ranges::equal(a, b, {}, lower, lower);
}

bool counts(const WindowKeys& row, KeyPlace place) { return !row.only || row.only == place; }

using Card = std::vector<std::pair<std::string, std::string>>;

Card make_card(KeyPlace place) {
  Card rows;
  std::string_view group;
  for (const WindowKeys& row : window_keys()) {
    if (!counts(row, place)) continue;
    if (group != row.group) rows.emplace_back(group = row.group, "");
    rows.emplace_back(row.shown, row.help);
  }
  return rows;
}

}  // namespace

const std::vector<WindowKeys>& window_keys() {
  static const std::vector<WindowKeys> table = [] {
    std::vector<WindowKeys> all = keys_of_hands();
    std::ranges::copy(keys_of_window(), std::back_inserter(all));
    add_views(all);
    return all;
  }();
  return table;
}

std::optional<KeyMeaning> meaning_of(std::string_view key, KeyPlace place) {
  for (const WindowKeys& row : window_keys())
    for (std::size_t i = 0; i < row.keys.size(); i++)
      if (counts(row, place) && same_key(key, row.keys[i])) return KeyMeaning{row.use, row.first + i};
  return {};
}

const char* key_for(KeyUse use, std::size_t which) {
  for (const WindowKeys& row : window_keys())
    if (row.use == use && which >= row.first && which < row.first + row.keys.size()) return row.keys[which - row.first];
  return "";
}

std::span<const std::pair<std::string, std::string>> key_card(KeyPlace place) {
  static const Card play = make_card(KeyPlace::play), replay = make_card(KeyPlace::replay);
  return place == KeyPlace::play ? play : replay;
}

std::string key_reference() {
  std::string out =
      "\n<a id=\"Keys\"></a>\n## Keys of the window\n\nA key that a scene asks for by its name, `scene:on(\"key\", "
      "\"x\", …)`, or has read, `scene.keys.x`, is the scene's; Esc never is. Of the others these are the window's, "
      "and what is left is heard by "
      "`scene:on(\"key\", …)`.\n\n| | key | |\n| --- | --- | --- |\n";
  for (const WindowKeys& row : window_keys()) out += text("| ", row.group, " | ", row.shown, " | ", row.help, " |\n");
  return out;
}

}  // namespace pantin
