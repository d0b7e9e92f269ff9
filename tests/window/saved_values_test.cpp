#include "player/saved_values.hpp"

#include <cstdlib>
#include <fstream>

#include "window/played.hpp"

using namespace pantin;

namespace {

/// A folder of the user's data, for the time of a test.
struct DataFolder {
  support::Folder folder;
  std::string before = std::getenv("XDG_DATA_HOME") ? std::getenv("XDG_DATA_HOME") : "";
  DataFolder() { setenv("XDG_DATA_HOME", folder.path.c_str(), 1); }
  ~DataFolder() { before.empty() ? unsetenv("XDG_DATA_HOME") : setenv("XDG_DATA_HOME", before.c_str(), 1); }
};

}  // namespace

TEST_CASE("saved_values: what a scene saves is there the next time, for this scene alone") {
  const DataFolder data;
  {
    player::SavedFile file("pantin:/scripts/scenes/a.lua");
    CHECK(file.values()->empty());
    *file.values() = {{"best", 12.5}, {"won", true}, {"name", std::string("k\xc3\xa4the")}};
  }
  CHECK(*player::SavedFile("pantin:/scripts/scenes/a.lua").values() ==
        SavedValues{{"best", 12.5}, {"won", true}, {"name", std::string("k\xc3\xa4the")}});
  CHECK(player::SavedFile("/elsewhere/a.lua").values()->empty());
}

TEST_CASE("saved_values: a file that cannot be understood is as if it were empty") {
  const DataFolder data;
  { (*player::SavedFile("/a.lua").values())["x"] = 1.0; }
  for (const auto& entry : std::filesystem::directory_iterator(data.folder / "pantin/saved"))
    support::write_file(entry.path().string(), "{\"x\": [");
  CHECK(player::SavedFile("/a.lua").values()->empty());
}

TEST_CASE("saved_values: a score lasts over a restart, another scene and another window", "[window]") {
  const DataFolder data;
  Played played(
      "scene:particle() scene.saved.plays = (scene.saved.plays or 0) + 1 scene:result('plays', scene.saved.plays)");
  CHECK(played.result("plays") == 1.0);
  pushed::tap(SDLK_r);
  played.frames(4);
  CHECK(played.result("plays") == 2.0);
  support::write_file(played.folder / "other.lua", "scene:particle() scene:result('plays', scene.saved.plays or 0)");
  REQUIRE(played.player->open(played.folder / "other.lua"));
  CHECK(played.result("plays") == 0.0);
  REQUIRE(played.player->open(played.folder / "scene.lua"));
  CHECK(played.result("plays") == 3.0);
}

TEST_CASE("saved_values: a play ends at its time, which is that of all scenes that open each other", "[window]") {
  const DataFolder data;
  player::RunOptions options;
  options.size = {640, 360};
  options.until = 0.7;
  Played played(R"(
    local n = (scene.saved.n or 0) + 1
    scene.saved.n = n
    scene:result("n", n)
    scene:particle()
    scene:after(0.2, function() scene:open("scene.lua") end))",
                options);
  int frames = 0;
  while (played.player->frame() && frames < 2000) frames++;
  CHECK(frames < 2000);
  CHECK(played.result("n") == 4.0);
  CHECK(played.world().time == Approx(0.1).margin(0.02));
}

TEST_CASE("saved_values: a scene opens the next with parameters, which a restart keeps and the next after it has not",
          "[window]") {
  const DataFolder data;
  Played played(R"(
    local level, name = scene:param("level", 1, { min = 1, max = 3 }), scene:param("name", "nobody")
    scene:result("level", level) scene:result("name", name)
    scene:particle()
    local open = level == 1 and { level = 2, name = "Ann = x" } or level == 2 and { level = 4 } or {}
    scene:on("key", "j", function() scene:open("scene.lua", open) end)
    scene:on("key", "l", function() scene:open("scene.lua", { levle = 2 }) end)
    scene:on("key", "m", function() scene:open("scene.lua") end))");
  const auto tap = [&](SDL_Keycode key) {
    pushed::tap(key);
    played.frames(8);
    return played.result("level");
  };
  const auto complaint = [&] { return played.player->complaint() ? played.player->complaint()->text : ""; };
  CHECK(tap(SDLK_j) == 2.0);
  CHECK(std::get<std::string>(played.player->scene().results().at("name")) == "Ann = x");
  CHECK(tap(SDLK_r) == 2.0);
  CHECK(complaint() == "");
  CHECK(tap(SDLK_j) == 2.0);
  CHECK(complaint() == "scene.lua:6: open: level=4: level must be at most 3, got 4");
  CHECK(tap(SDLK_r) == 2.0);
  tap(SDLK_l);
  CHECK(complaint() ==
        "scene.lua:7: open: levle=2: the scene has no parameter 'levle'. Did you mean 'level'? It has level, name");
  tap(SDLK_r);
  CHECK(tap(SDLK_m) == 1.0);
}

TEST_CASE("saved_values: a scene opens the next, and one that is not there is told once", "[window]") {
  const DataFolder data;
  Played played(R"(scene:particle() scene:at(0.5, function() scene:open("level2.lua") end))");
  support::write_file(played.folder / "level2.lua",
                      "scene.title = 'second' scene:particle() scene:at(0.01, function() scene:open('none.lua') end)");
  for (int i = 0; i < 100 && played.player->scene().title() != "second"; i++) played.frames(1);
  CHECK(played.player->scene().title() == "second");
  for (int i = 0; i < 100 && !played.player->complaint(); i++) played.frames(1);
  REQUIRE(played.player->complaint());
  CHECK_THAT(played.player->complaint()->text, Catch::Contains("level2.lua:1: open: there is no file 'none.lua'"));
  played.frames(10);
  CHECK(played.player->complaint()->times == 1);
}
