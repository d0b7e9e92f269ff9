// A recording of the window, played again in a window, by pushed events.
#include "player/replay.hpp"

#include <imgui.h>
#include <imgui_internal.h>

#include <map>

#include "bindings/recorded_person.hpp"
#include "lua/scene/open.hpp"
#include "measure/measure.hpp"
#include "player/replay_window.hpp"
#include "view/keys.hpp"
#include "window/played_chain.hpp"

using namespace pantin;
using Catch::Contains;
using support::Folder;

namespace {

constexpr int width = PlayedChain::width, height = PlayedChain::height;
// The slider above the buttons of the bar, at the lower edge.
constexpr double slider_left = 0.1 * width + 14, slider_right = 0.9 * width - 14;

player::RunOptions run_options() {
  player::RunOptions options;
  options.size = {width, height};
  options.paused = true;
  options.threads = 1;
  return options;
}

/// A play of two seconds in which a chain was pulled about by a hand.
std::string recorded(const Folder& folder) {
  const std::string text = PlayedChain::text();
  support::write_file(folder / "scene.lua", text);
  SceneOptions options;
  options.home = sources::folder();
  const auto scene = lua::open_scene(folder / "scene.lua", options);
  player::Recorder recorder(folder / "play.rec",
                            {player::program_version(), folder / "scene.lua", {}, {{folder / "scene.lua", text}}});
  for (int i = 0; i < 480; i++) {
    StepInput input;
    input.moves.push_back({0, vec(5 - 0.005 * i, 3 + 0.002 * i, 0), i > 10});
    if (i == 11) {
      Command grab;
      grab.kind = Command::Kind::grab;
      grab.point = scene->world().points.ids().back();
      input.commands.push_back(grab);
    }
    recorder.input(input);
    scene->world().input = input;
    scene->step();
    recorder.stepped(scene->world());
  }
  recorder.finish();
  return folder / "play.rec";
}

/// Its replay in a window that nobody sees, paused.
struct Watched {
  std::unique_ptr<player::ReplayWindow> window;

  explicit Watched(const std::string& file) {
    pushed::no_screen();
    window = std::make_unique<player::ReplayWindow>(file, run_options(), sources::folder());
    frames(3);
  }
  void frames(int n) {
    for (int i = 0; i < n; i++) REQUIRE(window->frame());
  }
  void tap(SDL_Keycode key) {
    pushed::tap(key);
    frames(2);
  }
  std::uint64_t tick() { return window->replay().tick(); }
  std::uint64_t hash() { return state_hash(window->replay().scene().world()); }
  /// Drags the slider to a part of the whole.
  void scrub(double part) {
    const double y = height - 44 - 45, x = slider_left + part * (slider_right - slider_left);
    pushed::move(x, y);
    frames(2);
    pushed::button(true, x, y);
    frames(20);
    pushed::button(false, x, y);
    frames(20);
  }
};

}  // namespace

TEST_CASE("replay in the window: scrubbed to a time and back, the state is that of the time to the bit", "[window]") {
  const Folder folder;
  const std::string file = recorded(folder);
  player::Replay straight(player::read_recording(file), run_options(), sources::folder());
  std::map<std::uint64_t, std::uint64_t> hashes = {{0, state_hash(straight.scene().world())}};
  while (straight.step()) hashes[straight.tick()] = state_hash(straight.scene().world());
  Watched watched(file);
  CHECK(watched.tick() == 0);
  for (const double part : {0.8, 0.3, 0.6, 0.1}) {
    watched.scrub(part);
    CHECK(static_cast<double>(watched.tick()) == Approx(480 * part).margin(25));
    CHECK(watched.hash() == hashes.at(watched.tick()));
  }
  CHECK(watched.window->replay().mismatch() == "");
}

TEST_CASE("replay in the window: it steps on and back, runs to its end, and starts again", "[window]") {
  const Folder folder;
  Watched watched(recorded(folder));
  for (int i = 0; i < 4; i++) watched.tap(SDLK_PERIOD);
  CHECK(watched.tick() == 4);
  const std::uint64_t hash = watched.hash();
  watched.tap(SDLK_PERIOD);
  CHECK(watched.hash() != hash);
  watched.tap(SDLK_COMMA);
  CHECK(watched.tick() == 4);
  CHECK(watched.hash() == hash);
  for (int i = 0; i < 6; i++) watched.tap(SDLK_COMMA);
  CHECK(watched.tick() == 0);
  for (int i = 0; i < 5; i++) watched.tap(SDLK_EQUALS);
  watched.tap(SDLK_SPACE);
  for (int i = 0; i < 400 && watched.tick() < 480; i++) watched.frames(1);
  CHECK(watched.tick() == 480);
  CHECK(watched.window->replay().mismatch() == "");
  for (int i = 0; i < 8; i++) watched.tap(SDLK_MINUS);  // else one slow frame has all of it
  watched.tap(SDLK_SPACE);
  CHECK(watched.tick() < 480);
}

TEST_CASE("replay in the window: it goes over from scene to scene and back, and looks at each as that wants to be seen",
          "[window]") {
  const Folder folder;
  const auto scene = [&](const std::string& name, const std::string& more) {
    support::write_file(folder / name, "scene.title = '" + name + "' scene:particle { at = vec(9, 9, 9) }" + more);
    return folder / name;
  };
  RecordedPerson person(scene("day.lua", ""), folder / "play.rec");
  person.play(1.0);
  person.open(scene("night.lua", "scene.dark, scene.step = true, 1 / 60"), {});
  person.play(1.0);
  person.finish();
  Watched watched(folder / "play.rec");
  const auto seen = [&](double part, const std::string& name) {
    watched.scrub(part);
    CHECK(watched.window->replay().time() == Approx(2.0 * part).margin(0.1));
    CHECK(SDL_GetWindowTitle(SDL_GL_GetCurrentWindow()) == name + ", recorded - Pantin");
    return watched.window->shows(View::dark);
  };
  CHECK_FALSE(seen(0.25, "day.lua"));
  CHECK(seen(0.75, "night.lua"));
  CHECK_FALSE(seen(0.4, "day.lua"));
  CHECK(watched.window->replay().mismatch() == "");
}

TEST_CASE("replay in the window: hands and undo do nothing, and it is said why", "[window]") {
  const Folder folder;
  Watched watched(recorded(folder));
  watched.tap(SDLK_PERIOD);
  const std::uint64_t hash = watched.hash();
  pushed::move(480, 200);
  pushed::button(true, 480, 200);
  watched.frames(2);
  CHECK_THAT(watched.window->told(), Contains("hands do nothing here"));
  pushed::move(600, 250);
  pushed::button(false, 600, 250);
  watched.frames(2);
  pushed::key(SDLK_LCTRL);
  pushed::tap(SDLK_z);
  pushed::key(SDLK_LCTRL, false);
  watched.frames(2);
  CHECK_THAT(watched.window->told(), Contains("nothing is undone here"));
  CHECK(watched.tick() == 1);
  CHECK(watched.hash() == hash);
}

TEST_CASE("replay in the window: where it parts from the recording is kept when one goes back", "[window]") {
  const Folder folder;
  std::string text = support::read_file(recorded(folder));
  const std::size_t at = text.find("{\"tick\":300,"), number = text.find("[[0,", at) + 4;
  REQUIRE(at != std::string::npos);
  text.replace(number, text.find(',', number) - number, "9.5");
  support::write_file(folder / "changed.rec", text);
  Watched watched(folder / "changed.rec");
  watched.scrub(0.99);
  CHECK(watched.window->replay().mismatch() == "");
  watched.tap(SDLK_EQUALS);
  watched.tap(SDLK_SPACE);
  for (int i = 0; i < 200 && watched.tick() < 480; i++) watched.frames(1);
  watched.frames(2);
  CHECK_THAT(watched.window->replay().mismatch(), Contains("between 1 s and 2 s"));
  watched.scrub(0.2);
  CHECK_THAT(watched.window->replay().mismatch(), Contains("between 1 s and 2 s"));
}

TEST_CASE("replay in the window: its keys are those of the one table, and the card shows them", "[window]") {
  const Folder folder;
  Watched watched(recorded(folder));
  watched.tap(SDLK_h);
  const ImGuiWindow* card = ImGui::FindWindowByName("keys");
  REQUIRE(card);
  CHECK(card->WasActive);
  watched.tap(SDLK_ESCAPE);  // closes the card alone
  watched.frames(2);
  CHECK_FALSE(card->WasActive);
  for (const auto& row : key_card(KeyPlace::replay)) CHECK(row.first != "ctrl + z");
  REQUIRE(meaning_of(",", KeyPlace::replay));
  CHECK(meaning_of(",", KeyPlace::replay)->use == KeyUse::step_back);
  CHECK_FALSE(meaning_of(","));  // where a scene is played it is the scene's
  pushed::tap(SDLK_q);
  bool over = false;
  for (int i = 0; i < 3 && !over; i++) over = !watched.window->frame();
  CHECK(over);
}
