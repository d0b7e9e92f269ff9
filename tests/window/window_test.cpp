#include "view/window.hpp"

#include <SDL.h>

#include <catch2/catch.hpp>
#include <cstdlib>

#include "window/pushed.hpp"

using namespace pantin;

namespace {

void push_motion(int x, int y) {
  SDL_Event event = {};
  event.type = SDL_MOUSEMOTION;
  event.motion.x = x;
  event.motion.y = y;
  SDL_PushEvent(&event);
}

void push_button(Uint32 type, Uint8 button, int x, int y) {
  SDL_Event event = {};
  event.type = type;
  event.button.button = button;
  event.button.x = x;
  event.button.y = y;
  SDL_PushEvent(&event);
}

void push_finger(Uint32 type, SDL_FingerID finger, float x, float y) {
  SDL_Event event = {};
  event.type = type;
  event.tfinger.touchId = 7;
  event.tfinger.fingerId = finger;
  event.tfinger.x = x;
  event.tfinger.y = y;
  SDL_PushEvent(&event);
}

void push_key(Uint32 type, SDL_Keycode key) {
  SDL_Event event = {};
  event.type = type;
  event.key.keysym.sym = key;
  SDL_PushEvent(&event);
}

}  // namespace

TEST_CASE("events make gestures, and the state follows from events alone", "[window]") {
  Window window("test", 400, 200, true);
  Gestures gestures;
  REQUIRE(window.poll(gestures));
  push_motion(10, 20);
  push_motion(15, 18);
  push_button(SDL_MOUSEBUTTONDOWN, SDL_BUTTON_LEFT, 15, 18);
  push_key(SDL_KEYDOWN, SDLK_LSHIFT);
  push_key(SDL_KEYDOWN, SDLK_SPACE);
  push_key(SDL_KEYDOWN, SDLK_x);
  REQUIRE(window.poll(gestures));
  CHECK(gestures.width == 400);
  CHECK(gestures.height == 200);
  REQUIRE(gestures.events.size() == 3);
  CHECK(gestures.events[1].dx == 5.0);
  CHECK(gestures.events[1].dy == -2.0);
  CHECK(gestures.events[2].kind == PointerEvent::Kind::press);
  CHECK(gestures.pointers.at(0).left);
  CHECK(gestures.pointers.at(0).x == 15.0);
  CHECK(gestures.shift);
  CHECK(gestures.keys == std::vector<std::string>{"left shift", "space", "x"});
  push_button(SDL_MOUSEBUTTONUP, SDL_BUTTON_LEFT, 16, 18);
  push_key(SDL_KEYUP, SDLK_LSHIFT);
  REQUIRE(window.poll(gestures));
  CHECK_FALSE(gestures.pointers.at(0).left);
  CHECK_FALSE(gestures.shift);
  CHECK(gestures.keys.empty());
}

TEST_CASE("each finger is a pointer of its own while it touches", "[window]") {
  Window window("test", 400, 200, true);
  Gestures gestures;
  push_finger(SDL_FINGERDOWN, 50, 0.25f, 0.5f);
  push_finger(SDL_FINGERDOWN, 51, 0.5f, 0.5f);
  push_finger(SDL_FINGERMOTION, 50, 0.75f, 0.5f);
  window.poll(gestures);
  REQUIRE(gestures.pointers.size() == 2);
  CHECK(gestures.pointers.at(1).x == Approx(300));
  CHECK(gestures.pointers.at(2).x == Approx(200));
  CHECK(gestures.pointers.at(2).left);
  push_finger(SDL_FINGERUP, 50, 0.75f, 0.5f);
  window.poll(gestures);
  REQUIRE(gestures.events.size() == 1);
  CHECK(gestures.events[0].kind == PointerEvent::Kind::release);
  CHECK(gestures.events[0].pointer == 1);
  CHECK(gestures.pointers.size() == 1);
}

TEST_CASE("a window that is no longer listened to lets all pointers go", "[window]") {
  Window window("test", 400, 200, true);
  Gestures gestures;
  push_motion(10, 20);
  push_button(SDL_MOUSEBUTTONDOWN, SDL_BUTTON_LEFT, 10, 20);
  push_finger(SDL_FINGERDOWN, 50, 0.25f, 0.5f);
  push_key(SDL_KEYDOWN, SDLK_LCTRL);
  push_key(SDL_KEYDOWN, SDLK_z);
  window.poll(gestures);
  CHECK(gestures.keys == std::vector<std::string>{"left ctrl", "ctrl+z"});
  SDL_Event event = {};
  event.type = SDL_WINDOWEVENT;
  event.window.event = SDL_WINDOWEVENT_FOCUS_LOST;
  SDL_PushEvent(&event);
  window.poll(gestures);
  REQUIRE(gestures.events.size() == 2);
  CHECK(gestures.events[0].kind == PointerEvent::Kind::release);
  CHECK(gestures.events[1].kind == PointerEvent::Kind::release);
  CHECK(gestures.pointers.size() == 1);
  CHECK_FALSE(gestures.pointers.at(0).left);
  CHECK_FALSE(gestures.control);
}

TEST_CASE("a pointer's event knows which keys came before it", "[window]") {
  Window window("test", 400, 200, true);
  Gestures gestures;
  push_key(SDL_KEYDOWN, SDLK_2);
  push_button(SDL_MOUSEBUTTONDOWN, SDL_BUTTON_LEFT, 10, 20);
  push_key(SDL_KEYDOWN, SDLK_1);
  push_button(SDL_MOUSEBUTTONUP, SDL_BUTTON_LEFT, 10, 20);
  window.poll(gestures);
  REQUIRE(gestures.events.size() == 2);
  CHECK(gestures.events[0].keys == 1);
  CHECK(gestures.events[1].keys == 2);
  gestures.erase_keys([](const std::string& key) { return key == "2"; });
  CHECK(gestures.events[0].keys == 0);
  CHECK(gestures.events[1].keys == 1);
}

TEST_CASE("a window that nobody would see is not opened, unless it was asked for", "[window]") {
  const char* display = std::getenv("DISPLAY");
  const std::string old = display ? display : "";
  unsetenv("DISPLAY");
  unsetenv("WAYLAND_DISPLAY");
  SDL_SetHintWithPriority(SDL_HINT_VIDEODRIVER, "", SDL_HINT_OVERRIDE);
  CHECK_FALSE(Display().seen());
  CHECK_THROWS_WITH(Window("test", 64, 64), Catch::Contains("no window can be opened"));
  pushed::no_screen();
  CHECK_NOTHROW(Window("test", 64, 64));
  if (display) setenv("DISPLAY", old.c_str(), 1);
}

TEST_CASE("closing the window ends polling", "[window]") {
  Window window("test", 64, 64, true);
  Gestures gestures;
  REQUIRE(window.poll(gestures));
  SDL_Event event = {};
  event.type = SDL_QUIT;
  SDL_PushEvent(&event);
  CHECK_FALSE(window.poll(gestures));
  CHECK(gestures.quit);
}
