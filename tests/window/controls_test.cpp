#include "player/controls.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>

#include "player/replay.hpp"
#include "window/played.hpp"

using namespace pantin;

namespace {

const char* const counts = R"(
  local p = scene:particle { at = vec(0, 0, 0) }
  scene.gravity = vec(0, 0, 0)
  local held, down, up = 0, 0, 0
  scene:on("key", function(key) if key == "left" then down = down + 1 end end)
  scene:on("key_up", function(key) if key == "left" then up = up + 1 end end)
  scene:on("step", function()
    if scene.keys.left then held = held + 1 p:push(vec(1, 0, 0)) end
    scene:result("held", held) scene:result("down", down) scene:result("up", up) scene:result("pause", scene.keys.space)
  end)
)";

}  // namespace

TEST_CASE("controls: a key that a scene reads is its own, held and let go", "[window]") {
  Played played(counts);
  played.frames(5);
  CHECK(played.result("held") == 0.0);
  pushed::key(SDLK_LEFT);
  pushed::key(SDLK_SPACE);
  played.frames(10);
  CHECK(played.result("held") > 0.0);
  CHECK(std::get<bool>(played.player->scene().results().at("pause")));
  CHECK(played.world().hands.size() < 2);  // the arrow is no cursor
  const std::uint64_t before = played.world().steps;
  pushed::key(SDLK_LEFT, false);
  pushed::key(SDLK_SPACE, false);
  played.frames(10);
  CHECK(played.world().steps > before);  // space did not pause it
  CHECK(played.result("down") == 1.0);
  CHECK(played.result("up") == 1.0);
  const double held = played.result("held");
  played.frames(5);
  CHECK(played.result("held") == held);
  pushed::tap(SDLK_LEFT);  // within one frame
  played.frames(10);
  CHECK(played.result("held") > held);
  CHECK(played.result("up") == 2.0);
}

TEST_CASE("controls: what is held is let go where the window loses the focus", "[window]") {
  Played played(counts);
  pushed::key(SDLK_LEFT);
  played.frames(5);
  SDL_Event event = {};
  event.type = SDL_WINDOWEVENT;
  event.window.event = SDL_WINDOWEVENT_FOCUS_LOST;
  SDL_PushEvent(&event);
  played.frames(5);
  CHECK(played.world().controls.empty());
}

TEST_CASE("controls: keys that were held are replayed to the bit", "[window]") {
  player::RunOptions options = Played::options_of(5.0, {640, 360});
  options.record = "keys.pantin";
  std::uint64_t hash = 0, steps = 0;
  Played played(counts, options);
  pushed::key(SDLK_LEFT);
  played.frames(12);
  pushed::key(SDLK_LEFT, false);
  played.frames(12);
  played.player->end_recording();
  hash = state_hash(played.world());
  steps = played.world().steps;
  CHECK(played.world().points.ids().size() == 1);
  player::Replay replay(player::read_recording(played.folder / "keys.pantin"), options, sources::folder());
  while (replay.scene().world().steps < steps) replay.step();
  CHECK(replay.mismatch() == "");
  CHECK(state_hash(replay.scene().world()) == hash);
  CHECK(std::get<double>(replay.scene().results().at("held")) == played.result("held"));
}

TEST_CASE("controls: a gamepad that is pulled out in play is at rest", "[window]") {
  pushed::no_screen();
  Played played(R"(
    local pressed = 0
    scene:on("key", "pad.start", function() pressed = pressed + 1 end)
    scene:on("step", function()
      scene:result("pressed", pressed)
      scene:result("x", scene.pad.left_x) scene:result("y", scene.pad.left_y) scene:result("start", scene.pad.start)
    end))");
  SDL_VirtualJoystickDesc desc = {};
  desc.version = SDL_VIRTUAL_JOYSTICK_DESC_VERSION;
  desc.type = SDL_JOYSTICK_TYPE_GAMECONTROLLER;
  desc.naxes = SDL_CONTROLLER_AXIS_MAX;
  desc.nbuttons = SDL_CONTROLLER_BUTTON_MAX;
  const int index = SDL_JoystickAttachVirtualEx(&desc);
  if (index < 0) {
    WARN("SDL has no virtual gamepads here: " << SDL_GetError());
    return;
  }
  played.frames(5);
  SDL_Joystick* pad = SDL_JoystickOpen(index);
  SDL_JoystickSetVirtualAxis(pad, SDL_CONTROLLER_AXIS_LEFTX, -32767);
  SDL_JoystickSetVirtualAxis(pad, SDL_CONTROLLER_AXIS_LEFTY, 32767);
  SDL_JoystickSetVirtualButton(pad, SDL_CONTROLLER_BUTTON_START, 1);
  played.frames(10);
  CHECK(played.result("x") == -1.0);
  CHECK(played.result("y") == -1.0);  // up > 0
  CHECK(std::get<bool>(played.player->scene().results().at("start")));
  CHECK(played.result("pressed") == 1.0);
  const std::uint64_t before = played.world().steps;
  SDL_JoystickDetachVirtual(index);
  played.frames(10);
  CHECK(played.world().steps > before);  // start did not pause it
  CHECK(played.result("x") == 0.0);
  CHECK_FALSE(std::get<bool>(played.player->scene().results().at("start")));
  SDL_JoystickClose(pad);
}

namespace {

/// A ball in the middle, and what the scene reads of the mouse.
std::string reads(const std::string& what) {
  return R"(
    scene.plane, scene.gravity = "xy", vec(0, 0, 0)
    scene.camera = { at = vec(0, 0, 10), look_at = vec(0, 0, 0) }
    local ball = scene:ball { radius = 0.5, at = vec(0, 0, 0) }
    local held, pressed, released, wheel = 0, 0, 0, 0
    scene:on("step", function()
      local mouse = scene.mouse
      )" +
         what +
         R"(
      if mouse.position then scene:result("x", mouse.position.x) scene:result("y", mouse.position.y) scene:result("z", mouse.position.z) end
      scene:result("held", held) scene:result("pressed", pressed) scene:result("released", released) scene:result("wheel", wheel)
    end)
  )";
}
const char* const reads_left = R"(
  if mouse.left then held = held + 1 ball:push(vec(1, 0, 0)) end
  if mouse.left_pressed then pressed = pressed + 1 end
  if mouse.left_released then released = released + 1 end)";

bool some_hand_holds(const World& world) {
  return std::ranges::any_of(world.hands, [](const Hand& hand) { return static_cast<bool>(hand.grab); });
}

}  // namespace

TEST_CASE("mouse: a button that a scene reads is its own, and no hand takes hold", "[window]") {
  Played played(reads(reads_left));
  CHECK_FALSE(played.player->scene().results().contains("x"));
  pushed::move(320, 180);
  played.frames(3);
  CHECK(played.result("x") == Approx(0.0).margin(1e-9));
  CHECK(played.result("y") == Approx(0.0).margin(1e-9));
  pushed::move(420, 80);
  played.frames(3);
  CHECK(played.result("x") > 0.5);
  CHECK(played.result("x") == Approx(played.result("y")));
  CHECK(played.result("z") == 0.0);
  pushed::move(320, 180);
  pushed::button(true, 320, 180);
  played.frames(6);
  CHECK(played.result("held") > 1.0);
  CHECK(played.result("pressed") == 1.0);
  CHECK(played.result("released") == 0.0);
  CHECK_FALSE(some_hand_holds(played.world()));
  pushed::button(false, 320, 180);
  played.frames(6);
  CHECK(played.result("released") == 1.0);
  pushed::button(true, 320, 180);  // within one frame
  pushed::button(false, 320, 180);
  played.frames(6);
  CHECK(played.result("pressed") == 2.0);
  CHECK(played.result("released") == 2.0);
  CHECK_FALSE(some_hand_holds(played.world()));
}

TEST_CASE("mouse: to know where it is takes nothing from the window", "[window]") {
  Played played(reads(""));
  pushed::move(320, 180);
  played.frames(3);
  pushed::button(true, 320, 180);
  played.frames(4);
  CHECK(some_hand_holds(played.world()));
  pushed::button(false, 320, 180);
  pushed::move(420, 180);
  played.frames(3);
  const double x = played.result("x");
  pushed::move(320, 180);
  pushed::wheel(3);
  pushed::move(420, 180);
  played.frames(4);
  CHECK(played.result("x") < 0.9 * x);  // it zoomed
}

TEST_CASE("mouse: the wheel and the right button that a scene reads move no camera", "[window]") {
  Played played(reads("wheel = wheel + mouse.wheel if mouse.right_pressed then pressed = pressed + 1 end"));
  pushed::move(420, 180);
  played.frames(3);
  const double x = played.result("x");
  pushed::wheel(3);
  played.frames(4);
  CHECK(played.result("wheel") == 3.0);
  pushed::button(true, 420, 180, SDL_BUTTON_RIGHT);
  pushed::move(500, 180);
  played.frames(4);
  pushed::button(false, 500, 180, SDL_BUTTON_RIGHT);
  pushed::move(420, 180);
  played.frames(4);
  CHECK(played.result("pressed") == 1.0);
  CHECK(played.result("x") == x);
}

TEST_CASE("mouse: what is pressed on a panel is not the scene's", "[window]") {
  Played played("scene:button('b', function() scene:result('b', true) end)" + reads(reads_left));
  played.click(30, 53);
  played.frames(3);
  CHECK(played.player->scene().results().contains("b"));
  CHECK(played.result("pressed") == 0.0);
}

TEST_CASE("mouse: a finger is its left button", "[window]") {
  Played played(reads(reads_left));
  pushed::finger(SDL_FINGERDOWN, 3, 420.0 / 640, 0.5);
  played.frames(4);
  CHECK(played.result("x") > 0.5);
  CHECK(played.result("held") > 0.0);
  pushed::finger(SDL_FINGERUP, 3, 420.0 / 640, 0.5);
  played.frames(4);
  CHECK(played.result("released") == 1.0);
  pushed::finger(SDL_FINGERDOWN, 3, 0.5, 0.5);  // within one frame
  pushed::finger(SDL_FINGERUP, 3, 0.5, 0.5);
  played.frames(6);
  CHECK(played.result("pressed") == 2.0);
  CHECK(played.result("x") == Approx(0.0).margin(1e-9));
  CHECK_FALSE(some_hand_holds(played.world()));
}

TEST_CASE("mouse: what it did is replayed to the bit", "[window]") {
  player::RunOptions options = Played::options_of(5.0, {640, 360});
  options.record = "mouse.pantin";
  Played played(reads(std::string(reads_left) + " wheel = wheel + mouse.wheel"), options);
  for (int i = 0; i < 12; i++) {
    pushed::move(320 + 7 * i, 180 - 3 * i);
    if (i % 4 == 0) pushed::button(true, 320 + 7 * i, 180);
    if (i % 4 == 2) pushed::button(false, 320 + 7 * i, 180);
    if (i % 5 == 0) pushed::wheel(-1);
    played.frames(2);
  }
  played.frames(6);
  played.player->end_recording();
  CHECK(played.result("pressed") == 3.0);
  const std::uint64_t steps = played.world().steps, hash = state_hash(played.world());
  player::Replay replay(player::read_recording(played.folder / "mouse.pantin"), options, sources::folder());
  while (replay.scene().world().steps < steps) replay.step();
  CHECK(replay.mismatch() == "");
  CHECK(state_hash(replay.scene().world()) == hash);
  CHECK(replay.scene().results() == played.player->scene().results());
}
