#include <catch2/catch.hpp>
#include <cmath>
#include <regex>
#include <sstream>

#include "bindings/exported.hpp"
#include "player/animation.hpp"
#include "support/process.hpp"
#include "support/sources.hpp"

using namespace pantin;
using namespace pantin::exported;
using namespace pantin::player;
using support::Folder;

namespace {

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

TEST_CASE("animation: a radius that follows the age does so") {
  const auto scene = growing_mote();
  Animation animation(scene->world(), 2.0, 1.0);
  run(*scene, 1.0, animation);
  const Folder folder;
  animation.write(folder / "a.glb", "grows");
  REQUIRE(support::finish({{"assimp", "dump", folder / "a.glb", folder / "a.assxml"}, {}, {}}).code == 0);
  const std::vector<double> size = last_key(support::read_file(folder / "a.assxml"), "particle 1", "Scaling");
  REQUIRE(size.size() == 3);
  CHECK(size[0] == Approx(1.1).epsilon(1e-5));
}

TEST_CASE("animation: pictures of shapes are in it, each once, with places on it") {
  const Folder folder;
  SceneOptions options;
  options.home = sources::folder();
  const auto scene = lua::open_scene_text(R"(
    scene:box { size = 1, picture = "crate.png" }
    scene:ball { radius = 1, at = vec(3, 0, 0), picture = "beach_ball.png" }
    scene:capsule { radius = 0.3, length = 1, at = vec(6, 0, 0), picture = { file = "crate.png", width = 0.5 } }
    scene:ball { radius = 1, at = vec(9, 0, 0) })",
                                          "test.lua", ".", options);
  Animation animation(scene->world(), 30.0, 1.0);
  animation.add_frames(scene->world());
  animation.write(folder / "a.glb", "pictures");
  const std::string info = support::finish({{"assimp", "info", folder / "a.glb"}, {}, {}}).out;
  CHECK(std::regex_search(info, std::regex("Textures \\(embed\\.\\): +2\n")));
  REQUIRE(support::finish({{"assimp", "dump", folder / "a.glb", folder / "a.assxml"}, {}, {}}).code == 0);
  const std::string dump = support::read_file(folder / "a.assxml");
  std::size_t places = 0;
  for (std::size_t at = 0; (at = dump.find("<TextureCoords ", at)) != std::string::npos; at++) places++;
  CHECK(places == 3);
}
