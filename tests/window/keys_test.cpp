// The table of the window's keys, and whose a key is: the window's or the scene's.
#include "view/keys.hpp"

#include <imgui.h>
#include <imgui_internal.h>

#include <catch2/catch.hpp>
#include <set>

#include "player/panels/pane.hpp"
#include "view/renderer.hpp"
#include "view/tools.hpp"
#include "view/views.hpp"
#include "window/played.hpp"

using namespace pantin;

TEST_CASE("keys: each is for one thing, and each tool, view and panel has one", "[window]") {
  for (const KeyPlace position : {KeyPlace::play, KeyPlace::replay}) {
    std::set<std::string> keys;
    for (const WindowKeys& row : window_keys())
      for (const char* key : row.keys)
        if (!row.only || row.only == position) CHECK(keys.insert(key).second);
  }
  std::set<std::string> given;
  for (std::size_t i = 0; i < tools().size(); i++) given.insert(key_for(KeyUse::tool, i));
  for (const NamedView& named : view_table()) given.insert(key_for(KeyUse::view, static_cast<std::size_t>(named.view)));
  for (std::size_t i = 0; i < std::size(player::pane_kinds); i++) given.insert(key_for(KeyUse::panel, i));
  CHECK(given.size() == tools().size() + view_table().size() + std::size(player::pane_kinds));
  CHECK_FALSE(given.contains(""));
  REQUIRE(meaning_of("3"));
  CHECK(meaning_of("3")->use == KeyUse::tool);
  CHECK(meaning_of("3")->which == static_cast<std::size_t>(ToolKind::join));
  CHECK_FALSE(meaning_of("j"));
  for (const WindowKeys& row : window_keys()) CHECK(key_reference().find(row.help) != std::string::npos);
}

TEST_CASE("keys: the scene has those that it names, the window its own, and the scene's listeners the rest",
          "[window]") {
  Played played(R"(
    scene:particle { at = vec(0, 0, 0) }
    local heard = ""
    local function hear(key) heard = heard .. key .. " " scene:result("heard", heard) end
    scene:on("key", hear)
    local named = scene:on("key", "b", function(key) scene:result("named", key) end)
    scene:on("key", "escape", hear)
    scene:button("give it back", function() named:cancel() end)
  )");
  const auto press = [&](SDL_Keycode key) {
    pushed::tap(key);
    played.frames(4);
  };
  press(SDLK_b);
  press(SDLK_j);
  press(SDLK_3);
  press(SDLK_UP);
  CHECK(std::get<std::string>(played.player->scene().results().at("heard")) == "b j ");
  CHECK(std::get<std::string>(played.player->scene().results().at("named")) == "b");
  CHECK(played.player->scene().keys() == std::vector<std::string>{"b", "escape"});
  played.click(40, 50);  // on the button
  press(SDLK_b);
  CHECK(played.player->scene().keys() == std::vector<std::string>{"escape"});
  CHECK(std::get<std::string>(played.player->scene().results().at("heard")) == "b j ");
  pushed::tap(SDLK_ESCAPE);
  played.frames(2);
  pushed::tap(SDLK_ESCAPE);
  bool over = false;
  for (int i = 0; i < 3 && !over; i++) over = !played.player->frame();
  CHECK(over);
}

TEST_CASE("keys: the card of all of them fits into 800 x 600", "[window]") {
  const Window window("test", 64, 64, true);
  Renderer renderer(800, 600);
  Overlay overlay;
  overlay.help = key_card();
  for (int i = 0; i < 4; i++) renderer.draw(World(), Camera(), overlay);
  const ImGuiWindow* card = ImGui::FindWindowByName("keys");
  REQUIRE(card);
  CHECK(card->ScrollMax.y == 0.0f);
  CHECK(card->ScrollMax.x == 0.0f);
  CHECK((card->Pos.x >= 0.0f && card->Pos.x + card->Size.x <= 800.0f));
  CHECK(card->ContentSize.x <= card->InnerRect.GetWidth());
}
