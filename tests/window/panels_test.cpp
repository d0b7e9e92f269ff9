// The panels of the window, by pushed events: what is done in them reaches the scene, and only there.
#include <imgui.h>

#include <catch2/catch.hpp>
#include <filesystem>

#include "window/played.hpp"

using namespace pantin;

namespace {

// The first slider of the parameters, at the left edge under the title.
constexpr double slider_left = 10 + 18, slider_right = 10 + 210 - 18, slider_y = 105;

}  // namespace

TEST_CASE("panels: a slider of a live parameter calls on_change, and the scene goes on", "[window]") {
  Played played(R"(
    scene:param("push", 1, { min = 0, max = 10, on_change = function(v) scene:result("push", v) end })
    scene:particle { at = vec(0, 0, 0) })");
  const std::uint64_t steps = played.world().steps;
  played.drag(slider_left + 20, slider_y, slider_right, slider_y);
  CHECK(played.result("push") == 10.0);
  CHECK(played.world().steps > steps);
  CHECK(played.world().hands.size() <= 1);
  played.player->undo();  // the whole drag
  CHECK_FALSE(played.player->scene().results().contains("push"));
  CHECK(played.player->scene().parameters()[0].value == SceneValue(1.0));
  played.player->redo();
  CHECK(played.result("push") == 10.0);
}

TEST_CASE("panels: a slider of another parameter opens the scene again with its value, in its steps", "[window]") {
  Played played(R"(
    local n = scene:param("count", 3, { min = 1, max = 9, step = 2 })
    for i = 1, n do scene:particle { at = vec(i, 0, 0) } end)");
  CHECK(played.world().particles.size() == 3);
  const std::uint64_t steps = played.world().steps;
  played.drag(slider_left + 40, slider_y, slider_right, slider_y);
  CHECK(played.world().particles.size() == 9);
  played.player->undo();  // the whole drag; the old scene goes on where it was
  CHECK(played.world().particles.size() == 3);
  CHECK(played.world().steps >= steps);
  played.player->redo();
  CHECK(played.world().particles.size() == 9);
  played.player->undo();
  played.player->undo();
  CHECK(played.world().particles.size() == 3);
  played.player->redo();
  played.drag(slider_right - 20, slider_y, slider_left, slider_y);
  CHECK(played.world().particles.size() == 1);
}

TEST_CASE("panels: a number that is typed beyond a range becomes its end, and the range is told", "[window]") {
  Played played("scene:param('push', 1, { min = 0, max = 10 }) scene:particle { at = vec(0, 0, 0) }");
  const auto type = [&](const std::string& number) {
    pushed::move(slider_left + 60, slider_y);
    played.frames(2);
    pushed::key(SDLK_LCTRL);
    played.frames(1);
    played.click(slider_left + 60, slider_y);
    pushed::key(SDLK_LCTRL, false);
    pushed::type(number);
    played.frames(3);
    pushed::tap(SDLK_RETURN);
    played.frames(3);
    return played.player->scene().parameters()[0].value;
  };
  CHECK(type("7") == SceneValue(7.0));
  CHECK(played.player->told().empty());
  CHECK(type("5000") == SceneValue(10.0));
  CHECK(played.player->told() == "push is from 0 to 10: 5000 became 10");
}

TEST_CASE("panels: what a saved file replaced comes back, then what a parameter did", "[window]") {
  const std::string text = R"(
    local n = scene:param("count", 3, { min = 1, max = 9, step = 2 })
    for i = 1, n do scene:particle { at = vec(i, 0, 0) } end)";
  Played played(text);
  played.player->set_parameter("count", 7.0);
  played.frames(3);
  played.save(text + " scene.title = 'saved'");
  played.player->undo();
  CHECK(played.player->scene().title().empty());
  CHECK(played.world().particles.size() == 7);
  played.player->undo();
  CHECK(played.world().particles.size() == 3);
}

TEST_CASE("what went wrong is shown until it is mended, and nothing good in its place", "[window]") {
  const std::string text = "scene:particle { at = vec(0, 0, 0) }";
  Played played(text);
  CHECK_FALSE(played.player->complaint());
  support::write_file(played.folder / "scene.lua", text + " oops(");
  for (int i = 0; i < 200 && !played.player->complaint(); i++) played.frames(1);
  REQUIRE(played.player->complaint());
  const auto here = std::filesystem::current_path();
  std::filesystem::current_path(played.folder.path);
  pushed::tap(SDLK_s);
  played.frames(3);
  std::filesystem::current_path(here);
  REQUIRE(played.player->said().back().good);
  REQUIRE(played.player->complaint());
  CHECK_FALSE(played.player->complaint()->good);
  played.save(text + " scene.title = 'saved'");
  CHECK_FALSE(played.player->complaint());
}

TEST_CASE("panels: a parameter that the scene refuses is told, and the old scene goes on", "[window]") {
  Played played(R"(
    local n = scene:param("count", 1, { min = 1, max = 9, step = 1 })
    assert(n < 5, "too many")
    scene:particle { at = vec(0, 0, 0) })");
  played.drag(slider_left + 20, slider_y, slider_right, slider_y);
  CHECK(played.world().particles.size() == 1);
  CHECK(std::get<double>(played.player->scene().parameters()[0].value) < 5.0);
  CHECK(played.player->failure().empty());
  const double time = played.world().time;
  played.frames(10);
  CHECK(played.world().time > time);
}

TEST_CASE("panels: a press on a panel does not take hold of what is behind it", "[window]") {
  Played played(R"(
    scene:param("a", 1, { min = 0, max = 2 })
    scene.camera = { at = vec(0, 0, 10), look_at = vec(0, 0, 0) }
    scene.gravity = vec(0, 0, 0)
    for x = -8, 8 do for y = -5, 5 do scene:particle { at = vec(x, y, 0) / 2 } end end
    scene:on("grab", function() scene:result("grabs", 1) end))");
  pushed::move(slider_left + 30, slider_y);
  pushed::button(true, slider_left + 30, slider_y);
  played.frames(10);
  CHECK_FALSE(played.player->scene().results().contains("grabs"));
  pushed::button(false, slider_left + 30, slider_y);
  played.frames(2);
  pushed::move(480, 270);
  pushed::button(true, 480, 270);
  played.frames(30);
  CHECK(played.player->scene().results().contains("grabs"));
}

TEST_CASE("panels: keys pause, slow and speed up time, and pass to the next scene and back", "[window]") {
  Played played("scene:particle { at = vec(0, 0, 0) }");
  pushed::tap(SDLK_SPACE);
  played.frames(2);
  const std::uint64_t steps = played.world().steps;
  played.frames(5);
  CHECK(played.world().steps == steps);
  pushed::tap(SDLK_PAGEDOWN);
  pushed::tap(SDLK_SPACE);
  played.frames(2);
  CHECK(played.player->scene().title() == "Strandbeest");
  CHECK(played.world().steps == 0);  // the key after it is for the scene that it opened
}

namespace {

/// Writes into the field of a panel where (x, y) [px] is, in place of what it had.
void write_into(Played& played, double x, double y, const char* text) {
  played.click(x, y);
  pushed::key(SDLK_LCTRL);
  pushed::tap(SDLK_a);
  played.frames(2);
  pushed::key(SDLK_LCTRL, false);
  pushed::type(text);
}

}  // namespace

TEST_CASE("panels: a field of the thing that was clicked is edited, and keys in it are not for the scene", "[window]") {
  Played played(R"(
    scene.gravity = vec(0, 0, 0)
    scene.camera = { at = vec(0, 0, 10), look_at = vec(0, 0, 0) }
    scene:particle { at = vec(0, 0, 0), name = "bead" }
    scene:on("key", function() scene:result("keys", 1) end))",
                5.0, {960, 540});
  pushed::tap(SDLK_F8);
  played.frames(3);
  played.click(480, 270);
  const double mass_x = 800, mass_y = 173;  // in the panel at the right edge, under the bar
  write_into(played, mass_x, mass_y, "2.5");
  pushed::tap(SDLK_j);
  played.frames(2);
  pushed::tap(SDLK_RETURN);
  played.frames(3);
  CHECK(played.world().points.at_slot(0).mass == 2.5);
  played.player->undo();
  CHECK(played.world().points.at_slot(0).mass == 1.0);
  played.player->redo();
  CHECK(played.world().points.at_slot(0).mass == 2.5);
  CHECK_FALSE(played.player->scene().results().contains("keys"));
  pushed::tap(SDLK_F8);
  played.frames(2);
  pushed::tap(SDLK_j);
  played.frames(30);
  CHECK(played.player->scene().results().contains("keys"));
}

TEST_CASE("panels: a coordinate is written with a power of ten as a mass is", "[window]") {
  Played played(R"(
    scene.gravity = vec(0, 0, 0)
    scene.camera = { at = vec(0, 0, 10), look_at = vec(0, 0, 0) }
    scene:particle { at = vec(0, 0, 0), name = "bead" })",
                5.0, {960, 540});
  pushed::tap(SDLK_F8);
  played.frames(3);
  played.click(480, 270);
  write_into(played, 685, 121, "2e-1");
  pushed::tap(SDLK_RETURN);
  played.frames(3);
  CHECK(position(played.world(), played.world().particles.ids().front())[0] == 0.2);
}

TEST_CASE("panels: all of them are drawn for a scene with probes and one with events, also in a window of one pixel",
          "[window]") {
  const std::string scene = GENERATE(std::string("chain"), "combine");
  Played played(support::read_file(sources::folder() + "/scripts/scenes/" + scene + ".lua"));
  for (const SDL_Keycode key : {SDLK_F2, SDLK_F3, SDLK_F4, SDLK_F5, SDLK_F6, SDLK_F7, SDLK_F8}) pushed::tap(key);
  played.frames(3);
  SDL_Window* window = nullptr;
  for (Uint32 id = 1; id < 1000 && !window; id++) window = SDL_GetWindowFromID(id);
  REQUIRE(window);
  SDL_SetWindowSize(window, 1, 1);
  played.frames(3);
  SDL_SetWindowSize(window, 640, 360);
  played.frames(3);
  CHECK(played.player->failure().empty());
}

TEST_CASE("panels: Esc closes the menu, asks, and then leaves", "[window]") {
  Played played("scene:particle { at = vec(0, 0, 0) }");
  played.click(610, 25);
  REQUIRE(ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel));
  pushed::tap(SDLK_ESCAPE);
  played.frames(2);
  CHECK_FALSE(ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel));
  pushed::tap(SDLK_ESCAPE);
  played.frames(2);
  pushed::tap(SDLK_ESCAPE);
  bool over = false;
  for (int i = 0; i < 3 && !over; i++) over = !played.player->frame();
  CHECK(over);
}
