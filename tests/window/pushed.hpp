#pragma once
// Events as SDL would send them, pushed by a test; and a player without a screen.
#include <SDL.h>

#include <string>

namespace pantin::pushed {

/// From now on windows need no screen.
inline void no_screen() { SDL_SetHintWithPriority(SDL_HINT_VIDEODRIVER, "offscreen", SDL_HINT_OVERRIDE); }

inline void move(double x, double y) {
  SDL_Event event = {};
  event.type = SDL_MOUSEMOTION;
  event.motion.x = static_cast<Sint32>(x);
  event.motion.y = static_cast<Sint32>(y);
  SDL_PushEvent(&event);
}

inline void button(bool down, double x, double y, Uint8 which = SDL_BUTTON_LEFT) {
  SDL_Event event = {};
  event.type = down ? SDL_MOUSEBUTTONDOWN : SDL_MOUSEBUTTONUP;
  event.button.button = which;
  event.button.x = static_cast<Sint32>(x);
  event.button.y = static_cast<Sint32>(y);
  SDL_PushEvent(&event);
}

inline void key(SDL_Keycode code, bool down = true) {
  SDL_Event event = {};
  event.type = down ? SDL_KEYDOWN : SDL_KEYUP;
  event.key.keysym.sym = code;
  SDL_PushEvent(&event);
}

/// Presses and lets go of a key.
inline void tap(SDL_Keycode code) {
  key(code, true);
  key(code, false);
}

/// Where it is as parts of the window.
inline void finger(Uint32 type, SDL_FingerID id, double x, double y) {
  SDL_Event event = {};
  event.type = type;
  event.tfinger.touchId = 1;
  event.tfinger.fingerId = id;
  event.tfinger.x = static_cast<float>(x);
  event.tfinger.y = static_cast<float>(y);
  SDL_PushEvent(&event);
}

inline void wheel(int notches) {
  SDL_Event event = {};
  event.type = SDL_MOUSEWHEEL;
  event.wheel.y = notches;
  SDL_PushEvent(&event);
}

inline void type(const std::string& words) {
  for (const char c : words) {
    SDL_Event event = {};
    event.type = SDL_TEXTINPUT;
    event.text.text[0] = c;
    SDL_PushEvent(&event);
  }
}

}  // namespace pantin::pushed
