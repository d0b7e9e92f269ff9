#include "scene/controls.hpp"

#include <algorithm>
#include <array>

namespace pantin {
namespace {

constexpr std::array<std::string_view, 54> words = {
    "left",        "right",        "up",         "down",        "space",      "return",   "escape",   "tab",
    "backspace",   "delete",       "insert",     "home",        "end",        "pageup",   "pagedown", "left shift",
    "right shift", "left ctrl",    "right ctrl", "left alt",    "right alt",  "capslock", "f1",       "f2",
    "f3",          "f4",           "f5",         "f6",          "f7",         "f8",       "f9",       "f10",
    "f11",         "f12",          "keypad 0",   "keypad 1",    "keypad 2",   "keypad 3", "keypad 4", "keypad 5",
    "keypad 6",    "keypad 7",     "keypad 8",   "keypad 9",    "keypad +",   "keypad -", "keypad *", "keypad /",
    "keypad .",    "keypad enter", "numlock",    "printscreen", "scrolllock", "pause"};

constexpr std::array<PadControl, 20> of_pad = {{{"left_x", true},
                                                {"left_y", true},
                                                {"right_x", true},
                                                {"right_y", true},
                                                {"left_trigger", true},
                                                {"right_trigger", true},
                                                {"a", false},
                                                {"b", false},
                                                {"x", false},
                                                {"y", false},
                                                {"left_shoulder", false},
                                                {"right_shoulder", false},
                                                {"left_stick", false},
                                                {"right_stick", false},
                                                {"start", false},
                                                {"back", false},
                                                {"up", false},
                                                {"down", false},
                                                {"left", false},
                                                {"right", false}}};

bool is_letter(std::string_view name) {
  if (name.empty()) return false;
  const auto first = static_cast<unsigned char>(name[0]);
  if (first >= 0x80) return name.size() <= 4;  // one of UTF-8
  return name.size() == 1 && first > ' ' && first < 0x7f && !(first >= 'A' && first <= 'Z');
}

}  // namespace

std::optional<std::string> key_named(std::string_view name) {
  if (is_letter(name)) return std::string(name);
  std::string key(name);
  std::replace(key.begin(), key.end(), '_', ' ');
  if (std::find(words.begin(), words.end(), key) == words.end()) return {};
  return key;
}

std::span<const std::string_view> key_words() { return words; }
std::span<const PadControl> pad_controls() { return of_pad; }

const PadControl* pad_control(std::string_view name) {
  const auto* found = std::find_if(of_pad.begin(), of_pad.end(), [&](const PadControl& c) { return c.name == name; });
  return found == of_pad.end() ? nullptr : found;
}

}  // namespace pantin
