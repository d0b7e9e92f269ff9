#include <catch2/catch.hpp>
#include <regex>
#include <sstream>

#include "bindings/exported.hpp"
#include "player/trajectory.hpp"
#include "support/process.hpp"

using namespace pantin;
using namespace pantin::exported;
using namespace pantin::player;
using support::Folder;

namespace {

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> list;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) list.push_back(line);
  return list;
}

}  // namespace

TEST_CASE("trajectory: another program reads each frame") {
  const Folder folder;
  const auto scene = thrown_rod();
  {
    Trajectory trajectory(folder / "a.xyz", 4.0, 1.0);
    run(*scene, 1.0, trajectory);
    trajectory.finish();
  }
  const auto converted = support::finish({{"obabel", "-ixyz", folder / "a.xyz", "-oxyz"}, {}, {}});
  CHECK(converted.err.find("5 molecules converted") != std::string::npos);
  const std::vector<std::string> read = lines(converted.out);
  REQUIRE(read.size() == 3 * 5 + 2 * 4);  // three particles in three frames, two in two
  CHECK(std::regex_search(read[4], std::regex(R"(0\.0+ +5\.0+ +0\.0+$)")));
  CHECK(std::regex_search(read.back(), std::regex(R"(2\.0000\d +3\.0+ +3\.0+$)")));  // the rod's far end
}

TEST_CASE("trajectory: a row has species, place, velocity, mass, radius, color and id") {
  const auto scene = thrown_rod();
  const std::vector<std::string> frame = lines(xyz_frame(scene->world()));
  CHECK(frame[0] == "3");
  CHECK(frame[1] == "Properties=species:S:1:pos:R:3:velo:R:3:mass:R:1:radius:R:1:color:R:3:id:I:1 Time=0");
  CHECK(frame[4].starts_with("fire_flies 0 5 0 0 0 2 2 0.25 1 0 0 "));
  CHECK(frame[2].starts_with("point 1 2 3 1 0 0 0 "));
}

TEST_CASE("trajectory: a radius and a color that follow the age do so") {
  const auto scene = growing_mote();
  while (scene->world().time < 1.0 - 0.5 * scene->world().settings.step) scene->step();
  CHECK(lines(xyz_frame(scene->world()))[2].starts_with("particle 0 0 0 0 0 0 1 1.1 1 1 0 "));
}

TEST_CASE("trajectory: in a periodic box its edges are told and places are in it") {
  const auto scene =
      opened("scene.gravity = vec(0, 0, 0) scene.box = vec(2, 3, 4) scene:particle { at = vec(2.5, -1, 1) }");
  const std::vector<std::string> frame = lines(xyz_frame(scene->world()));
  CHECK(frame[1].starts_with("Lattice=\"2 0 0 0 3 0 0 0 4\" pbc=\"T T T\" Properties="));
  CHECK(frame[2].starts_with("particle 0.5 2 1 "));
}

TEST_CASE("trajectory: a place that cannot be written to is an error") {
  CHECK_THROWS_WITH(Trajectory("/nowhere/a.xyz", 60.0, 1.0), Catch::Contains("/nowhere/a.xyz"));
}
