#include "view/edge_arrows.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "window/small_worlds.hpp"

using namespace pantin;

namespace {

constexpr int width = 800, height = 600;

/// From 10 m in front of the origin.
std::vector<Mark> marks_of(const World& world) {
  Stage stage;
  stage.empty = false;
  stage.size = 10.0;
  Camera camera;
  camera.look(vec(0, 0, 10), zero3());
  std::vector<Mark> marks;
  EdgeArrows().mark({world, stage, camera, width, height}, marks);
  return marks;
}

}  // namespace

TEST_CASE("edge arrows: they point to what left the picture, with its number", "[view]") {
  World world;
  small_worlds::particle(world, zero3());
  CHECK(marks_of(world).empty());

  small_worlds::particle(world, vec(20, 0, 0));
  std::vector<Mark> marks = marks_of(world);
  REQUIRE(marks.size() == 1);
  CHECK(marks[0].kind == Mark::Kind::arrow);
  CHECK(marks[0].to[0] > 0.9 * width);
  CHECK(marks[0].to[1] == Approx(0.5 * height));

  small_worlds::particle(world, vec(21, 0, 0));
  marks = marks_of(world);
  REQUIRE(marks.size() == 2);
  CHECK(marks[1].text == "2");

  SECTION("behind the eye it is on the side to turn to") {
    small_worlds::particle(world, vec(0, -1, 20));
    marks = marks_of(world);
    REQUIRE(marks.size() == 3);
    CHECK(std::ranges::any_of(marks,
                              [](const Mark& m) { return m.kind == Mark::Kind::arrow && m.to[1] > 0.7 * height; }));
  }
  SECTION("what is ten sizes of the scene away is told elsewhere") {
    small_worlds::particle(world, vec(0, -1000, 0));
    CHECK(marks_of(world).size() == 2);
  }
  SECTION("none for one who looks at a part") {
    for (int i = 0; i < 10; i++) small_worlds::particle(world, vec(-20 - i, 0, 0));
    CHECK(marks_of(world).empty());
  }
  SECTION("none in a periodic box") {
    world.settings.box = vec(50, 50, 50);
    CHECK(marks_of(world).empty());
  }
}
