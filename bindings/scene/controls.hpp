#pragma once
// Keys and gamepads as scenes know them. What is held has a name: a key's, as "left", "a" or "left shift"; of a gamepad
// "pad.left_x". Of a key it is 1, of an axis of a gamepad -1 to 1.
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pantin {

/// The name of a key, of which words may be joined by "_"; nothing where there is no such key. Letters of any keyboard are
/// keys.
std::optional<std::string> key_named(std::string_view name);
/// Keys that are more than a letter.
std::span<const std::string_view> key_words();

struct PadControl {
  std::string_view name;
  bool axis;  ///< else a button
};
std::span<const PadControl> pad_controls();
/// Null where there is none of this name.
const PadControl* pad_control(std::string_view name);
/// What begins the name of what a gamepad has.
inline constexpr std::string_view pad_prefix = "pad.";
/// What begins the name of what the mouse has: "mouse.position", "mouse.left", "mouse.middle", "mouse.right", "mouse.wheel".
inline constexpr std::string_view mouse_prefix = "mouse.";

}  // namespace pantin
