// `pantin play --untrusted`, attacked once its window is open.
#include "player/confine.hpp"

#include <catch2/catch.hpp>

#include "bindings/program_support.hpp"

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
  CHECK(support::lines(done.err) >= 23);
  CHECK(support::read_file(folder / "out/picture.png") != "");
}
