// A tour of all shipped scenes with all that can be shown, and hands in each.
#include <algorithm>
#include <filesystem>
#include <vector>

#include "lua/scene/open.hpp"
#include "measure/measure.hpp"
#include "window/played.hpp"

using namespace pantin;

namespace {

std::vector<std::string> shipped_scenes() {
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::directory_iterator(sources::folder() + "/scripts/scenes"))
    if (entry.path().extension() == ".lua") paths.push_back(entry.path().string());
  std::ranges::sort(paths);
  return paths;
}

/// A frame of one step, in which keys are pressed.
void frame(Played& played, const std::vector<SDL_Keycode>& keys = {}) {
  for (const SDL_Keycode key : keys) pushed::tap(key);
  pushed::tap(SDLK_PERIOD);
  played.frames(1);
}

/// A player in a small window, with all panels.
std::unique_ptr<Played> small_window() {
  auto played = std::make_unique<Played>("scene.title = 'empty'", 60.0, player::Size{320, 180});
  frame(*played, {SDLK_F2, SDLK_F3, SDLK_F4, SDLK_F5, SDLK_F6, SDLK_F7, SDLK_F8});
  return played;
}

// Of those that colour things only the last one shows, so each has its frames.
const std::vector<std::vector<SDL_Keycode>> all_views = {
    {SDLK_g, SDLK_a, SDLK_v, SDLK_w, SDLK_k, SDLK_z, SDLK_SLASH, SDLK_QUOTE, SDLK_d, SDLK_m},
    {SDLK_y},
    {SDLK_SEMICOLON},
    {SDLK_t, SDLK_d},
    {SDLK_e}};
const std::vector<SDL_Keycode> views_off = {SDLK_g, SDLK_a,     SDLK_v,     SDLK_w, SDLK_k,
                                            SDLK_z, SDLK_SLASH, SDLK_QUOTE, SDLK_e};

void expect_no_complaint(const Played& played) {
  std::string said = played.player->failure();
  for (const player::Said& line : played.player->said()) said += line.text + "\n";
  for (const std::string& warning : played.player->scene().warnings()) said += warning + "\n";
  CHECK(said == "");
}

std::uint64_t hash_without_window(const std::string& path, std::uint64_t steps) {
  SceneOptions options;
  options.home = sources::folder();
  options.script_limit = 0.0;
  const auto scene = lua::open_scene(path, options);
  while (scene->world().steps < steps) scene->step();
  return state_hash(scene->world());
}

void stroke(Played& played, SDL_Keycode tool, double x0, double y0, double x1, double y1) {
  pushed::move(x0, y0);
  frame(played, {tool});
  pushed::button(true, x0, y0);
  frame(played);
  pushed::move(x1, y1);
  frame(played);
  pushed::button(false, x1, y1);
  frame(played);
}

/// Drags, cuts through the middle, makes a rod, and takes that back, with no panels in the way.
void use_hands(Played& played) {
  frame(played, {SDLK_TAB});
  stroke(played, SDLK_1, 150, 90, 190, 60);
  stroke(played, SDLK_2, 100, 110, 220, 80);
  stroke(played, SDLK_8, 140, 60, 160, 70);
  pushed::key(SDLK_LCTRL);
  frame(played, {SDLK_z});
  pushed::key(SDLK_LCTRL, false);
  frame(played, {SDLK_TAB});
}

}  // namespace

TEST_CASE(
    "tour: each shipped scene, in all views and panels and in hands, gives no complaint, and views change nothing",
    "[window]") {
  const auto played = small_window();
  const std::vector<std::string> scenes = shipped_scenes();
  REQUIRE(scenes.size() > 20);
  for (const std::string& path : scenes) {
    INFO(path);
    REQUIRE(played->player->open(path));
    for (const auto& views : all_views) frame(*played, views);
    const std::uint64_t steps = played->world().steps;
    CHECK(steps == all_views.size());
    CHECK(state_hash(played->world()) == hash_without_window(path, steps));
    expect_no_complaint(*played);
    use_hands(*played);
    expect_no_complaint(*played);
    frame(*played, views_off);
  }
}
