#include <catch2/catch.hpp>
#include <cmath>
#include <regex>
#include <sstream>

#include "lua/scene/open.hpp"
#include "player/animation.hpp"
#include "player/trajectory.hpp"
#include "scene/scene.hpp"
#include "support/process.hpp"

using namespace pantin;
using namespace pantin::player;
using support::Folder;

namespace {

std::unique_ptr<Scene> opened(const std::string& source) { return lua::open_scene_text(source, "test.lua", ".", {}); }

// A rod that flies and turns by 90 degrees in a second, and a mote that lives for half of it.
std::unique_ptr<Scene> thrown_rod() {
  return opened(R"(
    scene.gravity = vec(0, 0, 0)
    local fireflies = scene:family("fire flies", { color = "#f00", radius = 0.25 })
    scene:body { name = "thrown", mass = 1, inertia = vec(1, 1, 1), at = vec(1, 2, 3), velocity = vec(1, 0, 0),
                 spin = vec(0, 0, math.pi / 2), points = { vec(0, 0, 0), vec(1, 0, 0) } }
    scene:particle { name = "mote", family = fireflies, mass = 2, at = vec(0, 5, 0), velocity = vec(0, 0, 2),
                     lifetime = 0.5 })");
}

template <class Frames>
void run(Scene& scene, double until, Frames& frames) {
  frames.add_frames(scene.world());
  while (scene.world().time < until - 0.5 * scene.world().settings.step) {
    scene.step();
    frames.add_frames(scene.world());
  }
}

/// The numbers of the last key of a node's list in assimp's dump.
std::vector<double> last_key(const std::string& dump, const std::string& node, const std::string& list) {
  const std::size_t channel = dump.find("<NodeAnim node=\"" + node + "\"");
  REQUIRE(channel != std::string::npos);
  const std::size_t end = dump.find("</" + list + "KeyList>", channel), key = dump.rfind("time=\"", end);
  std::istringstream rest(dump.substr(dump.find('>', key) + 1, 200));
  std::vector<double> numbers;
  for (double x; rest >> x;) numbers.push_back(x);
  return numbers;
}

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> list;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) list.push_back(line);
  return list;
}

}  // namespace

TEST_CASE("animation: another program sees each thing where it was, turned as it was, as long as it was there") {
  const Folder folder;
  const auto scene = thrown_rod();
  Animation animation(scene->world(), 30.0, 1.0);
  run(*scene, 1.0, animation);
  animation.write(folder / "a.glb", "a throw");
  REQUIRE(support::finish({{"assimp", "dump", folder / "a.glb", folder / "a.assxml"}, {}, {}}).code == 0);
  const std::string dump = support::read_file(folder / "a.assxml");
  CHECK(last_key(dump, "thrown", "Position") == std::vector<double>{2.0, 2.0, 3.0});
  const std::vector<double> turn = last_key(dump, "thrown", "Rotation");
  REQUIRE(turn.size() == 4);  // x, y, z, w
  CHECK(turn[2] == Approx(std::sqrt(0.5)).margin(1e-5));
  CHECK(turn[3] == Approx(std::sqrt(0.5)).margin(1e-5));
  CHECK(dump.find("<ScalingKey time=\"5.000000e+02\">") != std::string::npos);
  CHECK(last_key(dump, "mote", "Scaling") == std::vector<double>{0.0, 0.0, 0.0});
}

TEST_CASE("animation: a mesh has no triangle without area, and each turns its normal outwards") {
  const auto scene = thrown_rod();
  Stage stage = find_stage(scene->world());
  for (const Mesh& mesh : {body_mesh(make_figure(scene->world(), scene->world().bodies.ids()[0], stage)),
                           ball_mesh(Color{}), tube_mesh(Color{})}) {
    for (const Mesh::Patch& patch : mesh.patches) {
      const auto at = [&](const std::vector<float>& list, std::size_t corner) {
        const std::size_t k = 3u * patch.indices[corner];
        return vec(static_cast<double>(list[k]), static_cast<double>(list[k + 1]), static_cast<double>(list[k + 2]));
      };
      for (std::size_t i = 0; i < patch.indices.size(); i += 3) {
        const Vec3 a = at(patch.positions, i), b = at(patch.positions, i + 1), c = at(patch.positions, i + 2);
        const Vec3 area = cross(b - a, c - a);
        REQUIRE(norm(area) > 1e-9);
        REQUIRE(dot(area, at(patch.normals, i) + at(patch.normals, i + 1) + at(patch.normals, i + 2)) > 0.0);
      }
    }
  }
}

TEST_CASE("animation: what never moves has no channel, and one frame no animation") {
  const Folder folder;
  const auto scene = thrown_rod();
  Animation animation(scene->world(), 30.0, 1.0);
  animation.add_frames(scene->world());
  animation.write(folder / "a.glb", "still");
  const std::string info = support::finish({{"assimp", "info", folder / "a.glb"}, {}, {}}).out;
  CHECK(std::regex_search(info, std::regex("Animations: +0\n")));
  CHECK(std::regex_search(info, std::regex("thrown")));
}

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

TEST_CASE("exports: radii and colors that follow the age do so") {
  const auto scene = opened(R"(
    scene.gravity = vec(0, 0, 0)
    scene:particle { radius = function(age) return 0.1 + age end, color = function(age) return { age, 1, 0, 1 } end })");
  Animation animation(scene->world(), 2.0, 1.0);
  run(*scene, 1.0, animation);
  const Folder folder;
  animation.write(folder / "a.glb", "grows");
  REQUIRE(support::finish({{"assimp", "dump", folder / "a.glb", folder / "a.assxml"}, {}, {}}).code == 0);
  const std::vector<double> size = last_key(support::read_file(folder / "a.assxml"), "particle 1", "Scaling");
  REQUIRE(size.size() == 3);
  CHECK(size[0] == Approx(1.1).epsilon(1e-5));
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
