#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace pantin {

/// Names what points: the mouse is 0, fingers are 1 and up. (SDL cannot tell two mice apart.)
using PointerId = std::uint64_t;

struct Pointer {
  double x = 0.0, y = 0.0;  ///< [px] of the drawn picture, from the upper left corner
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
};

/// What hands did since the last poll, and the state that follows from all events so far. Nothing is ever asked of SDL,
/// so events pushed by a test and those of a person are the same.
struct Gestures {
  std::map<PointerId, Pointer> pointers;
  std::vector<PointerEvent> events;
  std::vector<std::string> keys;  ///< pressed since the last poll: "x", "space", "." …
  std::vector<std::string> held;  ///< keys that are down
  std::string text;               ///< typed since the last poll, UTF-8
  bool shift = false, control = false;
  int width = 0, height = 0;  ///< [px] of the window's drawable
  bool resized = false;
  bool quit = false;
};

}  // namespace pantin
