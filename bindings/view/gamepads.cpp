#include "view/gamepads.hpp"

#include <SDL.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace pantin {

namespace {

enum PressedBy : unsigned { by_shoulder = 1, by_trigger = 2, by_stick = 4, by_a = 8 };
constexpr double trigger_point = 0.4;
constexpr double deflected = 0.3;  // deflection from which on a stick counts as the last that moved

void set_bit(unsigned& bits, unsigned bit, bool on) { bits = on ? bits | bit : bits & ~bit; }

/// Keys that the other buttons stand for.
const char* key_of(int button) {
  switch (button) {
    case SDL_CONTROLLER_BUTTON_DPAD_LEFT: return "[";
    case SDL_CONTROLLER_BUTTON_DPAD_RIGHT: return "]";
    case SDL_CONTROLLER_BUTTON_START: return "space";
    case SDL_CONTROLLER_BUTTON_BACK: return "h";
    case SDL_CONTROLLER_BUTTON_X: return "ctrl+z";
    default: return nullptr;
  }
}

}  // namespace

Gamepads::Gamepads() { SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER); }

Gamepads::~Gamepads() {
  for (auto& [instance, pad] : pads_) SDL_GameControllerClose(pad.controller);
  SDL_QuitSubSystem(SDL_INIT_GAMECONTROLLER);
}

std::map<PointerId, Stick> Gamepads::sticks() const {
  std::map<PointerId, Stick> all;
  for (const auto& [instance, pad] : pads_)
    for (int side = 0; side < 2; side++) all[pad.left + static_cast<PointerId>(side)] = pad.sticks[side];
  return all;
}

void Gamepads::take(const SDL_Event& event, Gestures& gestures) {
  if (event.type == SDL_CONTROLLERDEVICEADDED) return add(event.cdevice.which, gestures);
  if (event.type == SDL_CONTROLLERDEVICEREMOVED) return remove(event.cdevice.which, gestures);
  if (event.type != SDL_CONTROLLERAXISMOTION && event.type != SDL_CONTROLLERBUTTONDOWN &&
      event.type != SDL_CONTROLLERBUTTONUP)
    return;
  const auto found = pads_.find(event.type == SDL_CONTROLLERAXISMOTION ? event.caxis.which : event.cbutton.which);
  if (found == pads_.end()) return;
  if (event.type == SDL_CONTROLLERAXISMOTION)
    turn(found->second, event.caxis.axis, event.caxis.value / 32767.0);
  else
    press(found->second, event.cbutton.button, event.type == SDL_CONTROLLERBUTTONDOWN, gestures);
}

void Gamepads::add(int index, Gestures& gestures) {
  SDL_GameController* controller = SDL_GameControllerOpen(index);
  if (!controller) {
    gestures.notes.push_back(std::string("a gamepad was plugged in, but cannot be used: ") + SDL_GetError());
    return;
  }
  const std::int32_t instance = SDL_JoystickInstanceID(SDL_GameControllerGetJoystick(controller));
  if (pads_.contains(instance)) return SDL_GameControllerClose(controller);  // its event came twice
  Pad pad;
  pad.controller = controller;
  const auto taken = [&](PointerId id) {
    return std::ranges::any_of(pads_, [&](const auto& entry) { return entry.second.left == id; });
  };
  for (pad.left = first_stick; taken(pad.left);) pad.left += 2;
  pads_[instance] = pad;
  gestures.notes.push_back("a gamepad: each stick is a hand, its shoulder button takes hold");
}

void Gamepads::remove(std::int32_t instance, Gestures& gestures) {
  const auto found = pads_.find(instance);
  if (found == pads_.end()) return;
  SDL_GameControllerClose(found->second.controller);
  pads_.erase(found);
  gestures.notes.push_back("the gamepad was pulled out; its hands let go");
}

void Gamepads::turn(Pad& pad, int axis, double value) {
  if (axis == SDL_CONTROLLER_AXIS_TRIGGERLEFT || axis == SDL_CONTROLLER_AXIS_TRIGGERRIGHT) {
    const int side = axis == SDL_CONTROLLER_AXIS_TRIGGERRIGHT;
    set_bit(pad.pressed_by[side], by_trigger, value > trigger_point);
    pad.sticks[side].pressed = pad.pressed_by[side] != 0;
    return;
  }
  const int side = axis == SDL_CONTROLLER_AXIS_RIGHTX || axis == SDL_CONTROLLER_AXIS_RIGHTY;
  const bool across = axis == SDL_CONTROLLER_AXIS_LEFTX || axis == SDL_CONTROLLER_AXIS_RIGHTX;
  (across ? pad.sticks[side].x : pad.sticks[side].y) = std::clamp(value, -1.0, 1.0);
  if (std::fabs(value) > deflected) pad.last = side;
}

void Gamepads::press(Pad& pad, int button, bool down, Gestures& gestures) {
  const auto stick = [&](int side, unsigned by) {
    set_bit(pad.pressed_by[side], by, down);
    pad.sticks[side].pressed = pad.pressed_by[side] != 0;
  };
  switch (button) {
    case SDL_CONTROLLER_BUTTON_LEFTSHOULDER: return stick(0, by_shoulder);
    case SDL_CONTROLLER_BUTTON_RIGHTSHOULDER: return stick(1, by_shoulder);
    case SDL_CONTROLLER_BUTTON_LEFTSTICK: return stick(0, by_stick);
    case SDL_CONTROLLER_BUTTON_RIGHTSTICK: return stick(1, by_stick);
    case SDL_CONTROLLER_BUTTON_A:
      if (down) return stick(pad.last, by_a);
      stick(0, by_a);
      return stick(1, by_a);
    default:
      if (const char* key = key_of(button); key && down) gestures.keys.push_back(key);
  }
}

}  // namespace pantin
