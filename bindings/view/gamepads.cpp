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

/// As scene/controls.hpp has it; empty: not there.
std::string name_of_axis(int axis) {
  switch (axis) {
    case SDL_CONTROLLER_AXIS_LEFTX: return "pad.left_x";
    case SDL_CONTROLLER_AXIS_LEFTY: return "pad.left_y";
    case SDL_CONTROLLER_AXIS_RIGHTX: return "pad.right_x";
    case SDL_CONTROLLER_AXIS_RIGHTY: return "pad.right_y";
    case SDL_CONTROLLER_AXIS_TRIGGERLEFT: return "pad.left_trigger";
    case SDL_CONTROLLER_AXIS_TRIGGERRIGHT: return "pad.right_trigger";
    default: return "";
  }
}

std::string name_of_button(int button) {
  switch (button) {
    case SDL_CONTROLLER_BUTTON_A: return "pad.a";
    case SDL_CONTROLLER_BUTTON_B: return "pad.b";
    case SDL_CONTROLLER_BUTTON_X: return "pad.x";
    case SDL_CONTROLLER_BUTTON_Y: return "pad.y";
    case SDL_CONTROLLER_BUTTON_LEFTSHOULDER: return "pad.left_shoulder";
    case SDL_CONTROLLER_BUTTON_RIGHTSHOULDER: return "pad.right_shoulder";
    case SDL_CONTROLLER_BUTTON_LEFTSTICK: return "pad.left_stick";
    case SDL_CONTROLLER_BUTTON_RIGHTSTICK: return "pad.right_stick";
    case SDL_CONTROLLER_BUTTON_START: return "pad.start";
    case SDL_CONTROLLER_BUTTON_BACK: return "pad.back";
    case SDL_CONTROLLER_BUTTON_DPAD_UP: return "pad.up";
    case SDL_CONTROLLER_BUTTON_DPAD_DOWN: return "pad.down";
    case SDL_CONTROLLER_BUTTON_DPAD_LEFT: return "pad.left";
    case SDL_CONTROLLER_BUTTON_DPAD_RIGHT: return "pad.right";
    default: return "";
  }
}

constexpr double rest = 0.15;  // a stick at rest is never quite in its middle

double beyond_rest(double value) {
  return std::copysign(std::max(0.0, (std::fabs(value) - rest) / (1.0 - rest)), value);
}

void hold(auto& pad, const std::string& name, double value) {
  if (name.empty()) return;
  if (value == 0.0)
    pad.held.erase(name);
  else
    pad.held[name] = value;
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

std::map<std::string, double> Gamepads::held() const {
  std::map<std::string, double> all;
  for (const auto& [instance, pad] : pads_)
    for (const auto& [name, value] : pad.held)
      if (std::fabs(value) > std::fabs(all[name])) all[name] = value;
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
    turn(found->second, event.caxis.axis, std::clamp(event.caxis.value / 32767.0, -1.0, 1.0));
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
  const bool upwards = axis == SDL_CONTROLLER_AXIS_LEFTY || axis == SDL_CONTROLLER_AXIS_RIGHTY;
  hold(pad, name_of_axis(axis), upwards ? -beyond_rest(value) : beyond_rest(value));
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
  const std::string name = name_of_button(button);
  hold(pad, name, down);
  if (down && std::ranges::count(gestures.of_scene, name) > 0) return;
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
