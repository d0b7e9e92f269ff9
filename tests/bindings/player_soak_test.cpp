#include "player/soak.hpp"

#include <catch2/catch.hpp>

#include "bindings/program_support.hpp"

using namespace pantin;

TEST_CASE("soak: scenes that ship go on as they began", "[slow]") {
  for (const char* name : {"chain", "fire", "marbles", "walker"}) {
    CAPTURE(name);
    const player::Soak soak =
        player::soak_scene(sources::folder() + "/scripts/scenes/" + name + ".lua", sources::folder(), 4000);
    CHECK(soak.fault() == "");
    CHECK(soak.steps == 4000);
  }
}

TEST_CASE("soak: what grows is told") {
  const support::Folder folder;
  support::write_file(folder / "grows.lua",
                      "local kept = {} scene:on('step', function() kept[#kept + 1] = "
                      "string.rep('x', 100000) .. #kept end) scene:particle()");
  const support::Finished soaked =
      support::use(folder, {"test", "soak", "--scene", folder / "grows.lua", "--steps", "400"});
  CHECK(soaked.code == 1);
  CHECK(soaked.out.find("its memory grows") != std::string::npos);
}

TEST_CASE("soak: an error that stops a scene is told") {
  const support::Folder folder;
  support::write_file(folder / "stops.lua", "scene:particle() scene:at(0.01, function() error('enough') end)");
  CHECK(player::soak_scene(folder / "stops.lua", sources::folder(), 100).fault().find("enough") != std::string::npos);
}
