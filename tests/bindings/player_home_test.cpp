#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>

#include "player/home.hpp"
#include "scene/errors.hpp"
#include "support/process.hpp"

using namespace pantin::player;
using namespace pantin::support;
using Catch::Contains;
using pantin::UsageError;

namespace {

/// A home with one shipped scene and one game.
struct Home : Folder {
  Home() {
    std::filesystem::create_directories(path / "scripts" / "scenes");
    std::filesystem::create_directories(path / "examples" / "games");
    write_file(path / "scripts" / "scenes" / "swing.lua", "");
    write_file(path / "examples" / "games" / "darts.lua", "");
  }
};

}  // namespace

TEST_CASE("home: PANTIN_HOME names it, and must hold scenes") {
  const char* before = std::getenv("PANTIN_HOME");
  std::string kept = before ? before : "";
  Home home;
  Folder empty;
  setenv("PANTIN_HOME", home.path.c_str(), 1);
  CHECK(find_home() == home.path);
  setenv("PANTIN_HOME", empty.path.c_str(), 1);
  CHECK_THROWS_WITH(find_home(), Contains("PANTIN_HOME") && Contains("scripts/scenes"));
  before ? setenv("PANTIN_HOME", kept.c_str(), 1) : unsetenv("PANTIN_HOME");
}

TEST_CASE("home: a scene is a file, or the name of a shipped scene or game") {
  Home home;
  std::string shipped = home / "scripts/scenes/swing.lua";
  CHECK(find_scene("swing", home.path) == shipped);
  CHECK(find_scene("swing.lua", home.path) == shipped);
  CHECK(find_scene(shipped, home.path) == shipped);
  CHECK(scene_name(shipped) == "swing");
  CHECK(find_scene("darts", home.path) == home / "examples/games/darts.lua");
}

TEST_CASE("home: an unknown scene's message names those there are") {
  Home home;
  CHECK_THROWS_AS(find_scene("swings", home.path), UsageError);
  CHECK_THROWS_WITH(find_scene("swings", home.path), Contains("'swings'") && Contains("(darts, swing)"));
  CHECK_THROWS_AS(find_scene("", home.path), UsageError);
  CHECK_THROWS_AS(find_scene("../scenes/swing", home.path), UsageError);
  CHECK_THROWS_WITH(find_scene(home.path, home.path), Contains("folder"));
}
