// The browser of scenes, and opening scenes without leaving the window.
#include <sys/stat.h>
#include <catch2/catch.hpp>
#include <filesystem>

#include "player/portraits.hpp"
#include "window/played.hpp"

using namespace pantin;

TEST_CASE("browser: without a scene the window shows all, and typing and Enter opens one", "[window]") {
  Played played("");
  CHECK(played.player->browsing());
  pushed::type("double pend");
  played.frames(2);
  pushed::tap(SDLK_RETURN);
  played.frames(3);
  CHECK_FALSE(played.player->browsing());
  CHECK(played.player->scene().title() == "Pendulum and double pendulum");
  CHECK(played.world().steps > 0);
  pushed::tap(SDLK_ESCAPE);
  played.frames(3);
  CHECK(played.player->browsing());
  const std::uint64_t steps = played.world().steps;
  played.frames(3);
  CHECK(played.world().steps == steps);
  pushed::tap(SDLK_ESCAPE);
  played.frames(3);
  CHECK_FALSE(played.player->browsing());
  CHECK(played.world().steps > steps);
}

TEST_CASE("browser: the field has the keys again after Esc, and what is called so comes first", "[window]") {
  Played played("");
  pushed::type("melt");
  played.frames(2);
  pushed::tap(SDLK_ESCAPE);
  played.frames(3);
  pushed::type("rings");
  played.frames(2);
  pushed::tap(SDLK_RETURN);
  played.frames(3);
  CHECK(played.player->scene().title() == "Rings");
  pushed::tap(SDLK_q);
  played.frames(3);
  CHECK(played.player->browsing());
  pushed::type("cloth");  // in place of what was searched before
  played.frames(2);
  pushed::tap(SDLK_RETURN);
  played.frames(3);
  CHECK(played.player->scene().title() == "Cloth");
}

TEST_CASE("browser: the field has the keys again after a scene that cannot be opened", "[window]") {
  Played played("scene.title = 'Mine' scene:particle { at = vec(0, 0, 0) }");
  support::write_file(played.folder / "broken.lua", "scene.title = 'Broken' error('no')");
  pushed::tap(SDLK_n);
  played.frames(3);
  pushed::type("broken");
  played.frames(2);
  pushed::tap(SDLK_RETURN);
  played.frames(3);
  CHECK(played.player->browsing());
  REQUIRE(played.player->said().size() == 1);
  pushed::type("zzz");
  played.frames(2);
  pushed::tap(SDLK_RETURN);  // nothing is called so
  played.frames(2);
  CHECK(played.player->said()[0].times == 1);
}

TEST_CASE("browser: a click opens a scene, Esc without one ends the program", "[window]") {
  Played played("");
  SECTION("click") {
    played.click(150, 150);
    CHECK_FALSE(played.player->browsing());
    CHECK(played.player->scene().title() == "Strandbeest");
  }
  SECTION("Esc") {
    pushed::tap(SDLK_ESCAPE);
    bool over = false;
    for (int i = 0; i < 5 && !over; i++) over = !played.player->frame();
    CHECK(over);
  }
}

TEST_CASE("browser: pictures are made and kept", "[window]") {
  Played played("scene.title = 'Mine' scene:particle { at = vec(0, 0, 0) }", 5.0, {480, 320});
  pushed::tap(SDLK_n);
  played.frames(3);
  REQUIRE(played.player->browsing());
  pushed::type("mine");
  for (int i = 0; i < 2000 && !std::filesystem::exists(played.folder / "cache/pantin"); i++) played.frames(1);
  CHECK(std::filesystem::exists(played.folder / "cache/pantin"));
  pushed::tap(SDLK_RETURN);
  played.frames(3);
  CHECK(played.player->scene().title() == "Mine");
}

TEST_CASE("browser: giving up a picture waits for no script, nor does the end", "[window]") {
  const Window window("test", 64, 64, true);
  support::Folder folder;
  support::write_file(folder / "endless.lua", "while true do end");
  support::write_file(folder / "good.lua", "scene:particle { at = vec(0, 0, 0) }");
  player::Portraits portraits({}, "");
  portraits.picture(folder / "endless.lua", 2.0);
  portraits.work(false);
  portraits.rest();
  CHECK(portraits.done());
  portraits.picture(folder / "good.lua", 2.0);
  portraits.work(false);
  CHECK_FALSE(portraits.done());  // its turn comes after the endless one
}

TEST_CASE("browser: scenes are told by title and first comment, what is no scene is left out", "[window]") {
  support::Folder folder;
  support::write_file(folder / "b.lua",
                      "#!/usr/bin/env pantin\n-- One: two\n-- three.\nlocal x = 1\n-- not this\nscene.title = 'B'\n");
  support::write_file(folder / "a.lua", "scene:particle { at = vec(0, 0, 0) }");
  support::write_file(folder / "c.lua", "return {}");
  std::filesystem::create_symlink("loop.lua", folder.path / "loop.lua");
  REQUIRE(mkfifo((folder / "endless.lua").c_str(), 0600) == 0);
  const auto scenes = player::list_scenes({folder.path, folder / ".", folder / "missing"});
  REQUIRE(scenes.size() == 2);
  CHECK(scenes[0].title == "a");
  CHECK(scenes[0].about.empty());
  CHECK(scenes[1].title == "B");
  CHECK(scenes[1].about == "One: two three.");
  CHECK(player::find_entry(scenes, folder / "b.lua") == 1);
  CHECK(player::find_entry(scenes, folder / "d.lua") == 2);
}

TEST_CASE("browser: scenes are in the order of the folder's list, then by name, and it says when a picture is taken",
          "[window]") {
  support::Folder folder;
  for (const char* name : {"a", "b", "c", "d"})
    support::write_file(folder / (std::string(name) + ".lua"), "scene.step = 1");
  support::write_file(folder / "order.txt", "c 6.5\n\nmissing 3\nb\n");
  std::string names;
  std::vector<double> at;
  for (const player::SceneEntry& scene : player::list_scenes({folder.path})) {
    names += scene.name;
    at.push_back(scene.portrait_at);
  }
  CHECK(names == "cbad");
  CHECK(at == std::vector{6.5, 2.0, 2.0, 2.0});
}

TEST_CASE("browser: Esc leads from a scene that a click opened back to it", "[window]") {
  Played played("");
  played.click(150, 200);
  played.frames(3);
  REQUIRE_FALSE(played.player->browsing());
  pushed::tap(SDLK_ESCAPE);
  played.frames(3);
  CHECK(played.player->browsing());
}

TEST_CASE("browser: two scenes with one title are told apart", "[window]") {
  support::Folder folder;
  std::filesystem::create_directory(folder / "copies");
  for (const char* path : {"a.lua", "b.lua", "copies/a.lua", "c.lua"})
    support::write_file(folder / path,
                        std::string("scene.title = '") + (path[0] == 'c' && path[1] == '.' ? "Other" : "Swing") + "'");
  std::string titles;
  for (const player::SceneEntry& scene : player::list_scenes({folder.path, folder / "copies"}))
    titles += scene.title + "; ";
  const std::string name = std::filesystem::path(folder.path).filename().string();
  CHECK(titles == "Swing (" + name + "/a); Swing (b); Other; Swing (copies/a); ");
}

TEST_CASE("opening: Esc stops a scene that does not come to its end, and the old one goes on", "[window]") {
  Played played("scene.title = 'Old' scene:particle { at = vec(0, 0, 0) }", 0.0);
  support::write_file(played.folder / "endless.lua", "while true do end");
  pushed::tap(SDLK_ESCAPE);
  CHECK_FALSE(played.player->open(played.folder / "endless.lua"));
  REQUIRE(played.player->said().size() == 1);
  CHECK(played.player->said()[0].text == "endless.lua:1: the script was interrupted");
  const double time = played.world().time;
  played.frames(5);
  CHECK(played.world().time > time);
  CHECK(played.player->scene().title() == "Old");
}

TEST_CASE("opening: the same error again is told once, with a count", "[window]") {
  Played played("scene:param('a', 1, { on_change = function(v) error('no') end })");
  for (int i = 0; i < 60; i++) played.player->set_parameter("a", 2.0);
  CHECK(played.player->open("missing.lua") == false);
  REQUIRE(played.player->said().size() == 2);
  CHECK(played.player->said()[0].times == 60);
  CHECK(played.player->said()[1].times == 1);
  played.frames(3);
}

TEST_CASE("opening: the first scene, too, is opened in a window that lives, and Esc stops it", "[window]") {
  pushed::no_screen();
  support::Folder folder;
  support::write_file(folder / "endless.lua", "while true do end");
  player::RunOptions options;
  options.script_limit = 30.0;
  const Display display;  // takes events from now on
  pushed::tap(SDLK_ESCAPE);
  CHECK_THROWS_WITH(player::Player(folder / "endless.lua", options, sources::folder()),
                    "endless.lua:1: the script was interrupted");
}
