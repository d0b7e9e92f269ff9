#include "view/steering.hpp"

#include <SDL.h>

#include <catch2/catch.hpp>

#include "view/window.hpp"

using namespace pantin;
using Kind = PointerEvent::Kind;

namespace {

Gestures picture() {
  Gestures gestures;
  gestures.width = 1000;
  gestures.height = 500;
  return gestures;
}

}  // namespace

TEST_CASE("a stick moves a cursor, presses by its button, and one that is gone lets go", "[view]") {
  Steering steering;
  Gestures gestures = picture();
  gestures.sticks[first_stick] = {0.1, 0.0, false};
  steering.move(gestures, 0.05);
  CHECK(gestures.pointers.empty());  // at rest
  gestures.sticks[first_stick] = {1.0, 0.0, false};
  steering.move(gestures, 0.05);
  REQUIRE(gestures.pointers.size() == 1);
  CHECK(gestures.pointers[first_stick].x > 500.0);
  CHECK(gestures.pointers[first_stick].y == 250.0);
  gestures.events.clear();
  gestures.sticks[first_stick] = {0.0, 0.0, true};
  steering.move(gestures, 0.05);
  REQUIRE(gestures.events.size() == 1);
  CHECK(gestures.events[0].kind == Kind::press);
  CHECK(gestures.pointers[first_stick].left);
  gestures = picture();
  steering.move(gestures, 0.05);
  REQUIRE(gestures.events.size() == 1);
  CHECK(gestures.events[0].kind == Kind::release);
  CHECK(gestures.events[0].pointer == first_stick);
  CHECK(gestures.pointers.empty());
}

TEST_CASE("arrow keys and Enter are a hand, which stays in the picture", "[view]") {
  Steering steering;
  Gestures gestures = picture();
  gestures.held = {"left", "return"};
  for (int i = 0; i < 100; i++) {
    gestures.events.clear();
    gestures.pointers.clear();
    steering.move(gestures, 0.1);
  }
  CHECK(gestures.pointers[key_cursor].x == 0.0);
  CHECK(gestures.pointers[key_cursor].left);
  gestures = picture();
  steering.move(gestures, 0.1);
  REQUIRE(gestures.events.size() == 1);
  CHECK(gestures.events[0].kind == Kind::release);
  CHECK_FALSE(gestures.pointers[key_cursor].left);
}

TEST_CASE("gamepads are plugged and pulled out while the window is open", "[window]") {
  Window window("test", 400, 200, true);
  Gestures gestures;
  REQUIRE(window.poll(gestures));
  SDL_VirtualJoystickDesc desc = {};
  desc.version = SDL_VIRTUAL_JOYSTICK_DESC_VERSION;
  desc.type = SDL_JOYSTICK_TYPE_GAMECONTROLLER;
  desc.naxes = SDL_CONTROLLER_AXIS_MAX;
  desc.nbuttons = SDL_CONTROLLER_BUTTON_MAX;
  desc.name = "a pad";
  const int index = SDL_JoystickAttachVirtualEx(&desc);
  if (index < 0) {
    WARN("SDL has no virtual gamepads here: " << SDL_GetError());
    return;
  }
  window.poll(gestures);
  REQUIRE(gestures.sticks.size() == 2);
  CHECK(gestures.notes.size() == 1);
  SDL_Joystick* pad = SDL_JoystickOpen(index);
  REQUIRE(pad != nullptr);
  SDL_JoystickSetVirtualAxis(pad, SDL_CONTROLLER_AXIS_RIGHTX, 32767);
  SDL_JoystickSetVirtualButton(pad, SDL_CONTROLLER_BUTTON_RIGHTSHOULDER, 1);
  window.poll(gestures);
  CHECK(gestures.notes.empty());
  CHECK(gestures.sticks[first_stick + 1].x == 1.0);
  CHECK(gestures.sticks[first_stick + 1].pressed);
  CHECK_FALSE(gestures.sticks[first_stick].pressed);
  SDL_JoystickDetachVirtual(index);
  window.poll(gestures);
  CHECK(gestures.sticks.empty());
  REQUIRE(gestures.notes.size() == 1);
  CHECK(gestures.notes[0] == "the gamepad was pulled out; its hands let go");
  SDL_JoystickClose(pad);
}
