#include "view/keys.hpp"

#include "base/check.hpp"
#include "view/views.hpp"

namespace pantin {

namespace {

using Use = KeyUse;

std::vector<WindowKeys> make_table() {
  const auto of_view = [](View shown, const char* key) {
    const auto place = static_cast<std::size_t>(shown);
    const NamedView& named = view_table()[place];
    const bool says = std::string_view(named.help).starts_with(named.name);
    return WindowKeys{"View", Use::view, {key}, key, says ? named.help : text(named.name, ": ", named.help), place};
  };
  return {
      {"Hands", Use::told, {}, "left drag", "use the tool: pull a point, and throw it"},
      {"Hands",
       Use::tool,
       {"1", "2", "3", "4", "5", "6", "7", "8", "9"},
       "1 … 9",
       "drag, cut, join, nail, push, spin, remove, make, heat"},
      {"Hands", Use::tool_before, {"["}, "[", "the tool before"},
      {"Hands", Use::tool_next, {"]"}, "]", "the next tool"},
      {"Hands", Use::cut, {"x"}, "x, ctrl + click", "cut what is under the pointer"},
      {"Hands", Use::undo, {"ctrl+z"}, "ctrl + z", "undo"},
      {"Hands", Use::redo, {"ctrl+shift+z", "ctrl+y"}, "ctrl + shift + z", "redo"},
      {"Hands", Use::told, {}, "fingers, sticks", "each is a hand of its own"},
      {"Hands",
       Use::told,
       {"left", "right", "up", "down", "return", "keypad enter", "keypad 2", "keypad 4", "keypad 5", "keypad 6",
        "keypad 8"},
       "arrows, enter",
       "a second hand (shift: slow)"},
      {"Time", Use::pause, {"space"}, "space", "pause, run"},
      {"Time", Use::step, {"."}, ".", "one step"},
      {"Time", Use::slower, {"-", "keypad -"}, "-", "slower"},
      {"Time", Use::faster, {"=", "+", "keypad +"}, "+", "faster"},
      {"Time", Use::own_pace, {"0"}, "0", "the scene's own pace"},
      {"Time", Use::restart, {"r"}, "r", "restart"},
      {"Window", Use::scenes, {"n"}, "n", "all scenes"},
      {"Window", Use::scene_before, {"pageup"}, "page up", "the scene before"},
      {"Window", Use::scene_next, {"pagedown"}, "page down", "the next scene"},
      {"Window",
       Use::panel,
       {"f1", "f2", "f3", "f4", "f5", "f6", "f7", "f8"},
       "F1 … F8",
       "panels: parameters, time, probes, energy, solver, phases, log, thing"},
      {"Window", Use::panels, {"tab"}, "tab", "hide the panels, show them"},
      {"Window", Use::picture, {"s"}, "s", "take a picture"},
      {"Window", Use::film, {"f9"}, "F9", "film what is seen, until it is pressed again"},
      {"Window", Use::help, {"h"}, "h", "show or hide the keys"},
      {"Window", Use::leave, {"escape", "q"}, "Esc, q", "back to the browser of scenes, or quit"},
      {"View", Use::told, {}, "right drag", "turn the view"},
      {"View", Use::told, {}, "middle drag", "shift the view (or shift + right)"},
      {"View", Use::told, {}, "wheel", "zoom"},
      {"View", Use::told, {}, "double click", "follow a thing; beside all, none"},
      {"View", Use::see_all, {"f"}, "f", "see the whole scene"},
      {"View", Use::see_freely, {"u"}, "u", "in perspective"},
      {"View", Use::see_front, {"i"}, "i", "from the front, without perspective"},
      {"View", Use::see_right, {"o"}, "o", "from the right side"},
      {"View", Use::see_top, {"p"}, "p", "from the top"},
      of_view(View::bodies, "b"),
      of_view(View::loads, "c"),
      of_view(View::shadows, "l"),
      of_view(View::rings, "g"),
      of_view(View::forces, "a"),
      of_view(View::velocities, "v"),
      of_view(View::trails, "w"),
      of_view(View::families, "m"),
      of_view(View::articulates, "y"),
      of_view(View::temperature, "t"),
      of_view(View::errors, "e"),
      of_view(View::cells, "k"),
      of_view(View::dark, "d"),
  };
}

}  // namespace

const std::vector<WindowKeys>& window_keys() {
  static const std::vector<WindowKeys> table = make_table();
  return table;
}

std::optional<KeyMeaning> meaning_of(std::string_view key) {
  for (const WindowKeys& row : window_keys())
    for (std::size_t i = 0; i < row.keys.size(); i++)
      if (key == row.keys[i]) return KeyMeaning{row.use, row.first + i};
  return {};
}

const char* key_for(KeyUse use, std::size_t which) {
  for (const WindowKeys& row : window_keys())
    if (row.use == use && which >= row.first && which < row.first + row.keys.size()) return row.keys[which - row.first];
  return "";
}

const std::vector<std::pair<std::string, std::string>>& key_card() {
  static const auto card = [] {
    std::vector<std::pair<std::string, std::string>> rows;
    std::string_view group;
    for (const WindowKeys& row : window_keys()) {
      if (group != row.group) rows.emplace_back(group = row.group, "");
      rows.emplace_back(row.shown, row.help);
    }
    return rows;
  }();
  return card;
}

std::string key_reference() {
  std::string out =
      "\n<a id=\"Keys\"></a>\n## Keys of the window\n\nA key that a scene asks for by its name, `scene:on(\"key\", "
      "\"x\", "
      "…)`, is the scene's; Esc never is. Of the others these are the window's, and what is left is heard by "
      "`scene:on(\"key\", …)`.\n\n| | key | |\n| --- | --- | --- |\n";
  for (const WindowKeys& row : window_keys()) out += text("| ", row.group, " | ", row.shown, " | ", row.help, " |\n");
  return out;
}

}  // namespace pantin
