#pragma once
#include <map>
#include <string>

#include "view/gestures.hpp"

union SDL_Event;
struct _SDL_GameController;

namespace pantin {

/// The sticks of all gamepads, plugged and pulled out at any time. A stick is pressed by the shoulder button or trigger on
/// its side, or by a push on itself; A presses the one that moved last.
class Gamepads {
 public:
  Gamepads();
  ~Gamepads();
  Gamepads(const Gamepads&) = delete;
  Gamepads& operator=(const Gamepads&) = delete;

  /// Takes events of gamepads, and puts the keys that their other buttons stand for, and what is to be told, into gestures.
  void take(const SDL_Event& event, Gestures& gestures);
  std::map<PointerId, Stick> sticks() const;
  /// What is held, by names of scene/controls.hpp: of all pads what is pressed most; no zeros.
  std::map<std::string, double> held() const;

 private:
  struct Pad {
    _SDL_GameController* controller = nullptr;
    PointerId left = 0;  ///< the right one's is the next
    Stick sticks[2];
    unsigned pressed_by[2] = {0, 0};  ///< bits of what presses a stick
    int last = 0;                     ///< which stick moved last
    std::map<std::string, double> held;
  };
  void add(int index, Gestures& gestures);
  void remove(std::int32_t instance, Gestures& gestures);
  void turn(Pad& pad, int axis, double value);
  void press(Pad& pad, int button, bool down, Gestures& gestures);

  std::map<std::int32_t, Pad> pads_;  // by SDL's instance
};

}  // namespace pantin
