#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace pantin {

/// Names what points: the mouse is 0, fingers are 1 and up; then come the cursor of the arrow keys and those of gamepads'
/// sticks. (SDL cannot tell two mice apart.)
using PointerId = std::uint64_t;
constexpr PointerId key_cursor = 1000, first_stick = 1001;

/// How far a gamepad's stick is pressed to the right and down, -1 to 1.
struct Stick {
  double x = 0.0, y = 0.0;
  bool pressed = false;  ///< its button
};

struct Pointer {
  double x = 0.0, y = 0.0;  ///< [px] of the window, from the upper left corner
  bool left = false, middle = false, right = false;
};

struct PointerEvent {
  enum class Kind : std::uint8_t { move, press, release, wheel };
  enum class Button : std::uint8_t { none, left, middle, right };
  Kind kind = Kind::move;
  Button button = Button::none;
  PointerId pointer = 0;
  double x = 0.0, y = 0.0;    ///< [px]
  double dx = 0.0, dy = 0.0;  ///< [px] of a move; notches of the wheel, up > 0
  bool shift = false, control = false;
  int clicks = 1;        ///< of a press: 2 is a double click
  std::size_t keys = 0;  ///< of the gestures' keys, that were pressed before
};

/// What hands did since the last poll, and the state that follows from all events so far. Nothing is ever asked of SDL,
/// so events pushed by a test and those of a person are the same.
struct Gestures {
  std::map<PointerId, Pointer> pointers;
  std::vector<PointerEvent> events;
  std::vector<std::string> keys;      ///< pressed since the last poll: "x", "space", "ctrl+z" …
  std::vector<std::string> held;      ///< keys that are down
  std::string text;                   ///< typed since the last poll, UTF-8
  std::map<std::string, double> pad;  ///< what is held of gamepads, by names of scene/controls.hpp; no zeros
  std::vector<std::string> of_scene;  ///< of these and "mouse.left" …, what is the scene's alone; kept
  std::map<PointerId, Stick> sticks;  ///< of the gamepads that are plugged in
  std::vector<std::string> notes;     ///< to be told: a gamepad came or went
  bool shift = false, control = false;
  int width = 0, height = 0;  ///< [px] of the window
  bool resized = false;
  bool quit = false;

  /// With its left button, or a finger, no hand takes hold.
  bool scene_has_mouse() const { return std::ranges::count(of_scene, "mouse.left") > 0; }
  /// Takes out keys that are for something else.
  void erase_keys(const auto& taken) {
    for (std::size_t i = 0; i < keys.size();) {
      if (!taken(keys[i])) {
        i++;
        continue;
      }
      keys.erase(keys.begin() + static_cast<std::ptrdiff_t>(i));
      for (PointerEvent& event : events)
        if (event.keys > i) event.keys--;
    }
  }
};

}  // namespace pantin
