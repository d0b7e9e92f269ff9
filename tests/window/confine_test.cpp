// `pantin play --untrusted` and `pantin replay --untrusted`, attacked once their windows are open.
#include "player/confine.hpp"

#include <catch2/catch.hpp>

#include "bindings/program_support.hpp"
#include "lua/scene/open.hpp"
#include "player/recording.hpp"
#include "player/replay.hpp"

using namespace pantin;
using Catch::Contains;

TEST_CASE("confine: a window that plays a stranger's scene reaches nothing but its folder and its outputs",
          "[window]") {
  if (sources::preload("attacks").empty()) return;
  support::Folder folder;
  std::filesystem::create_directory(folder.path / "out");
  support::write_file(folder / "attacked.lua", support::swing);
  const support::Finished done = support::finish(
      {{sources::program(), "play", "--untrusted", "attacked.lua", "--until", "0.1", "--out", "out/picture.png"},
       {"PANTIN_HOME=" + sources::folder(), "LD_PRELOAD=" + sources::preload("attacks")},
       folder.path,
       -1});
  INFO(done.err);
  CHECK(done.code == 0);
  CHECK_THAT(done.err, Contains("ALLOWED writes beside the outputs"));
  CHECK_THAT(done.err, Contains("refused reads /etc/passwd"));
  CHECK_THAT(done.err, Contains("refused opens a socket"));
  CHECK_THAT(done.err, Contains("refused clones"));
  CHECK(support::lines(done.err) >= 28);
  CHECK(support::read_file(folder / "out/picture.png") != "");
}

TEST_CASE("confine: a window that shows a stranger's recording reaches nothing but its folder", "[window]") {
  if (sources::preload("attacks").empty()) return;
  support::Folder folder;
  const auto scene = lua::open_scene_text(support::swing, folder / "scene.lua", folder.path, {});
  player::Recorder recorder(
      folder / "attacked.lua",
      {player::program_version(), folder / "scene.lua", {}, {{folder / "scene.lua", support::swing}}});
  for (int i = 0; i < 24; i++) {
    scene->step();
    recorder.stepped(scene->world());
  }
  recorder.finish();
  const support::Finished done =
      support::finish({{sources::program(), "replay", "--untrusted", "attacked.lua", "--until", "0.1"},
                       {"PANTIN_HOME=" + sources::folder(), "LD_PRELOAD=" + sources::preload("attacks")},
                       folder.path,
                       -1});
  INFO(done.err);
  CHECK(done.code == 0);
  CHECK_THAT(done.err, Contains("refused reads /etc/passwd"));
  CHECK_THAT(done.err, Contains("ALLOWED reads the scene's folder"));
  CHECK_THAT(done.err, Contains("refused writes the scene"));
  CHECK_THAT(done.err, Contains("refused opens a socket"));
  CHECK_THAT(done.err, Contains("refused clones"));
  CHECK(support::lines(done.err) >= 28);
}
