#include "player/controls.hpp"

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
    scene:on("step", function()
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
  const std::uint64_t before = played.world().steps;
  SDL_JoystickDetachVirtual(index);
  played.frames(10);
  CHECK(played.world().steps > before);  // start did not pause it
  CHECK(played.result("x") == 0.0);
  CHECK_FALSE(std::get<bool>(played.player->scene().results().at("start")));
  SDL_JoystickClose(pad);
}
