// Pictures on shapes and as sprites, as they are seen.
#include "view/sheets.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <iostream>
#include <numbers>
#include <sstream>

#include "base/rotation.hpp"
#include "edit/edit.hpp"
#include "shapes/hull.hpp"
#include "view/renderer.hpp"
#include "view/window.hpp"
#include "window/pictured.hpp"
#include "window/small_worlds.hpp"

using namespace pantin;
using namespace pantin::pictured;

namespace {

constexpr int wide = 320, high = 320;

struct Seen {
  World world;
  Camera camera;
  std::vector<std::uint8_t> pixels;

  void draw(int samples = 0) {
    Renderer renderer(wide, high, samples);
    renderer.open(world);
    renderer.draw(world, camera);
    pixels = renderer.read_pixels();
  }
  std::array<int, 3> at(int x, int y) const {
    const std::size_t first = 4u * static_cast<std::size_t>(y * wide + x);
    return {pixels[first], pixels[first + 1], pixels[first + 2]};
  }
  /// As "rg" where red and green are bright and blue is not.
  static std::string name(std::array<int, 3> c) {
    std::string letters;
    const int most = std::max({c[0], c[1], c[2]});
    for (std::size_t i = 0; i < 3; i++)
      if (c[i] > 0.7 * most) letters += "rgb"[i];
    return letters;
  }
  std::string name(Vec3 place) const {
    const auto p = camera.project(place, wide, high);
    REQUIRE(p);
    return name(at(static_cast<int>(p->x), static_cast<int>(p->y)));
  }
  /// Of what is around a place, as seen: left and right above, left and right below.
  std::string around(Vec3 place, double by) const {
    std::string all;
    for (const double up : {by, -by})
      for (const double right : {-by, by})
        all += name(place + camera.right() * right + camera.up() * up) + (up > 0.0 || right < 0.0 ? " " : "");
    return all;
  }
};

ShapeDef covered(const Geometry& geometry, std::shared_ptr<const Picture> picture, double width = 0.0) {
  ShapeDef def = small_worlds::shape(geometry);
  def.color = {1, 1, 1, 1};
  def.cover = cover(std::move(picture), geometry, width);
  return def;
}

BodyId add_covered_body(World& world, const ShapeDef& shape) {
  BodyDef def;
  def.shapes = {shape};
  return add_body(world, def);
}

}  // namespace

TEST_CASE("sheets: on each face of a box the picture is upright, as from outside", "[window]") {
  const Window window("test", wide, high, true);
  Seen seen;
  add_covered_body(seen.world, covered(BoxShape{vec(1, 1.5, 1.2)}, quarters()));
  const Vec3 from =
      GENERATE(vec(0, 0, 1), vec(0, 0, -1), vec(1, 0, 0), vec(-1, 0, 0), vec(0, 1, 0.02), vec(0, -1, 0.02));
  seen.camera.look(from * 8.0, zero3());
  seen.draw(GENERATE(0, 4));
  INFO(from[0] << ' ' << from[1] << ' ' << from[2]);
  CHECK(seen.around(zero3(), 0.4) == "r g b rg");
}

TEST_CASE("sheets: a hull, a cylinder, a capsule and a ball have their picture upright, too", "[window]") {
  const Window window("test", wide, high, true);
  std::vector<Vec3> corners;
  for (int i = 0; i < 8; i++) corners.push_back(vec(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
  const Geometry geometry = GENERATE_COPY(Geometry{make_hull(corners)}, Geometry{CylinderShape{1.0, 1.0}},
                                          Geometry{CapsuleShape{0.8, 0.5}}, Geometry{BallShape{1.0}});
  Seen seen;
  ShapeDef def = covered(geometry, quarters());
  const bool round = std::holds_alternative<CylinderShape>(geometry) || std::holds_alternative<CapsuleShape>(geometry);
  if (round) def.orientation = turn_to(vec(0, 1, 0));
  add_covered_body(seen.world, def);
  seen.camera.look(vec(0, 0, 8), zero3());
  seen.draw();
  CHECK(seen.around(zero3(), 0.3) == "r g b rg");
}

TEST_CASE("sheets: a ball shows no speckle, and no seam at its back", "[window]") {
  const Window window("test", wide, high, true);
  Seen seen;
  add_covered_body(seen.world, covered(BallShape{1.0}, picture(64, 32, [](double, double) { return blue; })));
  seen.camera.look(vec(0.3, 0.2, GENERATE(6.0, -6.0)), zero3());
  seen.draw();
  const auto middle = seen.camera.project(zero3(), wide, high);
  const int reach = static_cast<int>(0.7 / middle->pixel);
  int others = 0;
  for (int y = -reach; y < reach; y++)
    for (int x = -reach; x < reach; x++)
      if (x * x + y * y < reach * reach)
        others += Seen::name(seen.at(static_cast<int>(middle->x) + x, static_cast<int>(middle->y) + y)) != "b";
  CHECK(others == 0);
}

TEST_CASE("sheets: a picture with a width is repeated, on a box as on a floor", "[window]") {
  const Window window("test", wide, high, true);
  Seen seen;
  const auto stripes = picture(64, 64, [](double x, double) { return x < 0.5 ? red : blue; });
  if (GENERATE(true, false)) {
    add_covered_body(seen.world, covered(BoxShape{vec(2, 2, 2)}, stripes, 1.0));
    seen.camera.look(vec(0, 0, 10), zero3());
    for (int i = -3; i < 4; i++) {
      seen.draw();
      CHECK(seen.name(vec(0.5 * i + 0.25, 0.1, 2)) == (i % 2 == 0 ? "r" : "b"));
    }
    return;
  }
  ShapeDef floor = covered(BoxShape{vec(1, 1, 1)}, stripes, 1.0);
  floor.geometry = HalfSpaceShape{};
  floor.orientation = turn_to(vec(0, 1, 0));
  add_shape(seen.world, floor);
  small_worlds::chain(seen.world, 3);
  seen.camera.look(vec(0, 6, 9), zero3());
  seen.draw();
  for (int i = -2; i < 3; i++) CHECK(seen.name(vec(0.5 * i + 0.25, 0, 3)) == (i % 2 == 0 ? "r" : "b"));
}

TEST_CASE("sheets: the colour is that of the picture times the shape's, and shows where the picture is clear",
          "[window]") {
  const Window window("test", wide, high, true);
  Seen seen;
  ShapeDef def =
      covered(BoxShape{vec(1, 1, 1)}, picture(64, 64, [](double x, double) { return x < 0.5 ? yellow : clear; }));
  def.color = {0, 1, 1, 1};
  add_covered_body(seen.world, def);
  seen.camera.look(vec(0, 0, 8), zero3());
  seen.draw();
  CHECK(seen.around(zero3(), 0.5) == "g gb g gb");
}

TEST_CASE("sheets: a sprite stands in the scene's plane and turns, else it faces the camera", "[window]") {
  const Window window("test", wide, high, true);
  Seen seen;
  const bool flat = GENERATE(true, false);
  if (flat) seen.world.plane.normal = 2;
  BodyDef def;
  def.shapes = {small_worlds::shape(BallShape{0.2})};
  def.sprite = std::make_shared<const Cover>(Cover{quarters(), 2.0, zero3(), zero3()});
  def.orientation = quaternion_of(vec(0, 0, 1), 0.5 * std::numbers::pi);
  add_body(seen.world, def);
  seen.camera.look(flat ? vec(0, 0, 8) : vec(3, 5, -4), zero3());
  seen.draw();
  CHECK(seen.around(zero3(), 0.5) == (flat ? "g rg r b" : "r g b rg"));
  const auto p = seen.camera.project(seen.camera.right() * -0.5 + seen.camera.up() * 0.5, wide, high);
  const std::array<int, 3> shown = seen.at(static_cast<int>(p->x), static_cast<int>(p->y));
  CHECK(shown == (flat ? std::array<int, 3>{0, 255, 0} : std::array<int, 3>{255, 0, 0}));  // as the picture is
}

TEST_CASE("sheets: what is clear of a sprite is not there, and particles of a family have one", "[window]") {
  const Window window("test", wide, high, true);
  Seen bare, seen;
  bare.camera.look(vec(0, 0, 8), zero3());
  seen.camera = bare.camera;
  FamilyDef family;
  family.name = "birds";
  family.sprite = std::make_shared<const Cover>(
      Cover{picture(64, 64, [](double x, double) { return x < 0.5 ? red : clear; }), 2.0, zero3(), zero3()});
  ParticleDef def;
  def.family = add_family(seen.world, family);
  add_particle(seen.world, def);
  for (Seen* one : {&bare, &seen}) one->draw(4);
  CHECK(seen.name(vec(-0.5, 0, 0)) == "r");
  const auto p = seen.camera.project(vec(0.5, 0.1, 0), wide, high);
  const int x = static_cast<int>(p->x), y = static_cast<int>(p->y);
  CHECK(std::abs(seen.at(x, y)[1] - bare.at(x, y)[1]) < 30);
}

TEST_CASE("sheets: a picture that cannot be made out leaves the colour, and says so", "[window]") {
  const Window window("test", wide, high, true);
  Seen seen;
  ShapeDef def = covered(BoxShape{vec(1, 1, 1)},
                         std::make_shared<const Picture>(Picture{"broken.png", "\x89PNG\r\n\x1a\n....", 4, 4}));
  def.color = {1, 0, 0, 1};
  add_covered_body(seen.world, def);
  seen.camera.look(vec(0, 0, 8), zero3());
  std::ostringstream told;
  std::streambuf* const usual = std::cerr.rdbuf(told.rdbuf());
  seen.draw();
  std::cerr.rdbuf(usual);
  CHECK(told.str() == "pantin: the picture 'broken.png' cannot be made out\n");
  CHECK(seen.name(vec(0, 0, 1)) == "r");
}

TEST_CASE("sheets: a draw list has one for each picture that is shown, and none without", "[view]") {
  World world;
  Camera camera;
  const auto one = quarters(), other = quarters();
  const BodyId first = add_covered_body(world, covered(BoxShape{vec(1, 1, 1)}, one));
  add_covered_body(world, covered(BallShape{1.0}, other));
  add_covered_body(world, covered(BoxShape{vec(1, 1, 1)}, one));
  DrawListMaker maker;
  DrawList list;
  const Stage stage = find_stage(world);
  const auto draw = [&] { maker.draw(world, camera, stage, {}, high, list); };
  draw();
  REQUIRE(list.sheets.size() == 2);
  CHECK(list.sheets[0].corners.size() == 72);
  CHECK(list.sheets[1].globes.size() == 1);
  CHECK(list.corners.empty());
  world.shapes[world.bodies[first].shapes[0]].cover.reset();
  draw();
  CHECK(list.corners.size() == 36);
  CHECK(list.sheets[0].corners.size() == 36);
  for (const BodyId body : world.bodies.ids()) remove(world, body);
  draw();
  draw();
  CHECK(list.sheets.empty());
}
