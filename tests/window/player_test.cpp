// What a frame of the window asks for: nothing, once it was drawn.
#include <imgui.h>
#include <imgui_internal.h>

#include <catch2/catch.hpp>
#include <ctime>

#include "support/allocations.hpp"
#include "view/keys.hpp"
#include "view/views.hpp"
#include "window/played.hpp"

using namespace pantin;

namespace {

const char* const scene = R"(
  scene.title = "A title that is longer than what fits in a string"
  scene.camera = { at = vec(2, 1, 8), look_at = vec(2, 0, 0) }
  scene:param("number of something, a long name", 2, { min = 1, max = 9, on_change = function() end })
  scene:param("choice", "that which is long", { choices = { "that which is long", "another that is long" } })
  scene:param("words", "words that are longer than a short string")
  scene:param("yes", true)
  scene:button("a button with a long name", function() end)
  local a, b = scene:particle { at = vec(0, 0, 0), name = "a bead with a long name" }, scene:particle { at = vec(1, 0, 0) }
  scene:connect(a, b, force.spring { stiffness = 10 })
  scene:nail(a)
  local first = scene:body { points = { { at = vec(2, 0, 0), mass = 1 }, { at = vec(3, 0, 0), mass = 1 } }, name = "the first of the bodies" }
  local second = scene:body { points = { { at = vec(3, 0, 0), mass = 1 }, { at = vec(4, 0, 0), mass = 1 } } }
  scene:hinge(first.points[2], second.points[1])
  scene:nail(first.points[1])
  scene:rod(b, second.points[2])
  scene:probe("height of the end, which is long", function() return b.position.y end)
  scene:probe("other", function() return scene.time end)
  scene:every(0.1, a, function() end)
  scene:over(0, 1, function() end)
  scene:when(function() return false end, function() end)
  scene:on("step", function()
    scene.draw:text(vec(0, 0, 0), "a text that is longer than a short string")
    scene.draw:arrow(vec(0, 0, 0), vec(1, 1, 0))
  end)
  scene:at(0.02, function() a.mass = 1 end)
  local gone = scene:particle { at = vec(0, 2, 0), name = "what goes" }
  scene:at(0.02, function() gone:remove() end)
  scene:at(0.03, gone, function() end)
)";

std::uint64_t asked_in(Played& played, int frames) {
  const std::uint64_t before = allocations();
  for (int i = 0; i < frames; i++) played.player->frame();
  return allocations() - before;
}

}  // namespace

TEST_CASE("a frame in which nothing changes asks for no memory, with all panels and views", "[window]") {
  Played played(scene, 5.0, {800, 600});
  played.frames(20);
  played.click(400, 300);
  for (const NamedView& named : view_table())
    if (named.view != View::families && named.view != View::articulates)
      pushed::tap(*key_for(KeyUse::view, static_cast<std::size_t>(named.view)));
  for (const SDL_Keycode key : {SDLK_F2, SDLK_F3, SDLK_F4, SDLK_F5, SDLK_F6, SDLK_F7, SDLK_F8}) pushed::tap(key);
  played.frames(10);
  pushed::tap(SDLK_SPACE);
  played.frames(20);
  CHECK(asked_in(played, 10) == 0);
  pushed::tap(SDLK_h);
  played.frames(10);
  CHECK(asked_in(played, 10) == 0);
}

TEST_CASE("a frame of the browser asks for no memory, once its pictures are there", "[window]") {
  Played played("", 5.0, {480, 320});
  // Of processor time, of which a picture takes as much on a busy machine.
  const auto now = [] { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; };
  const double start = now();
  for (double last = start; now() - last < 3.0 && now() - start < 60.0;)
    if (asked_in(played, 5) > 0) last = now();
  CHECK(asked_in(played, 10) == 0);
}

TEST_CASE("what fell out is brought back by a button, and that is undone", "[window]") {
  Played played(R"(
    scene.gravity = vec(0, 0, 0)
    scene.camera = { at = vec(0, 0, 10), look_at = vec(0, 0, 0) }
    scene:box { size = vec(1, 1, 1), mass = 1, at = vec(-1, 0, 0) }
    local lost = scene:box { size = vec(1, 1, 1), mass = 1, at = vec(1, 0, 0) }
    scene:at(0.01, function() lost.position = vec(0, -1000, 0) end)
    scene:probe("height", function() return lost.position.y end)
  )",
                5.0, {960, 540});
  const auto height = [&] { return played.world().motion_of(played.world().bodies.ids()[1]).x[1]; };
  for (int i = 0; i < 500 && height() > -1.0; i++) played.frames(1);
  REQUIRE(height() == Approx(-1000.0));
  const ImGuiWindow* button = nullptr;
  for (int i = 0; i < 200 && !(button && button->Active); i++) {
    played.frames(1);
    button = ImGui::FindWindowByName("lost");
  }
  REQUIRE(button);
  played.frames(2);
  const ImVec2 at = {button->Pos.x + 0.8f * button->Size.x, button->Pos.y + 0.5f * button->Size.y};
  played.click(static_cast<double>(at.x), static_cast<double>(at.y));
  played.frames(5);
  CHECK(height() > 0.0);
  played.player->undo();
  CHECK(height() == Approx(-1000.0));
}

TEST_CASE("Esc lets go of what is held, closes what was opened, and asks before it quits", "[window]") {
  Played played(R"(
    scene.gravity = vec(0, 0, 0)
    scene.camera = { at = vec(0, 0, 10), look_at = vec(0, 0, 0) }
    scene:particle { at = vec(0, 0, 0), mass = 1 }
  )");
  const auto escape = [&] {
    pushed::tap(SDLK_ESCAPE);
    return played.player->frame() && played.player->frame();
  };
  pushed::move(320, 180);
  played.frames(2);
  pushed::button(true, 320, 180);
  played.frames(3);
  REQUIRE(played.world().hands.at(0).grab);
  pushed::tap(SDLK_F5);
  pushed::tap(SDLK_h);
  played.frames(2);
  CHECK(escape());
  played.frames(3);
  CHECK_FALSE(played.world().hands.at(0).grab);
  CHECK(escape());  // the card of keys
  CHECK(ImGui::FindWindowByName("Solver")->Active);
  CHECK(escape());
  played.frames(1);
  CHECK_FALSE(ImGui::FindWindowByName("Solver")->Active);
  CHECK(escape());  // asks
  CHECK_FALSE(escape());
}

TEST_CASE("Tab leaves the scene alone in the window", "[window]") {
  Played played("scene:particle { at = vec(0, 0, 0), mass = 1 }");
  CHECK(ImGui::FindWindowByName("tools")->Active);
  pushed::tap(SDLK_TAB);
  played.frames(2);
  CHECK_FALSE(ImGui::FindWindowByName("tools")->Active);
  CHECK_FALSE(ImGui::FindWindowByName("bar")->Active);
  pushed::tap(SDLK_TAB);
  played.frames(2);
  CHECK(ImGui::FindWindowByName("bar")->Active);
}
