#include "view/shadows.hpp"

#include <catch2/catch.hpp>
#include <cstdlib>
#include <numbers>
#include <vector>

#include "base/rotation.hpp"
#include "edit/edit.hpp"
#include "view/renderer.hpp"
#include "view/window.hpp"
#include "window/pictured.hpp"
#include "window/small_worlds.hpp"

using namespace pantin;

namespace {

/// Pictures of one world with and without shadows.
struct LitAndShaded {
  static constexpr int wide = 320, tall = 180;
  const Camera& camera;
  std::vector<std::uint8_t> lit, shaded;

  LitAndShaded(const World& world, const Camera& camera_of, int samples) : camera(camera_of) {
    Renderer renderer(wide, tall, samples);
    renderer.open(world);
    Overlay overlay;
    renderer.draw(world, camera, overlay);
    shaded = renderer.read_pixels();
    overlay.views.set(View::shadows, false);
    renderer.draw(world, camera, overlay);
    lit = renderer.read_pixels();
  }
  /// By how much a place is darker with them.
  int darker(Vec3 place) const {
    const auto seen = camera.project(place, wide, tall);
    REQUIRE(seen);
    const auto at = 4u * static_cast<std::size_t>(static_cast<int>(seen->y) * wide + static_cast<int>(seen->x));
    return lit[at] - shaded[at];
  }
};

/// On a table of 4 m by 4 m whose top is 2 m above the ground.
void add_table_with(World& world, const Geometry& thing, Vec3 at) {
  add_shape(world, small_worlds::shape(BoxShape{vec(2, 0.1, 2)}, vec(0, 1.9, 0)));
  add_shape(world, small_worlds::shape(BoxShape{vec(0.1, 0.9, 0.1)}, vec(0, 0.9, 0)));
  add_shape(world, small_worlds::shape(thing, at));
}

}  // namespace

TEST_CASE("in pictures things throw shadows on each other, at once without samples on the ground alone", "[window]") {
  const Window window("test", 320, 180, true);
  const Vec3 middle = vec(0.3, 2.8, 0.2);
  const Geometry thing =
      GENERATE(Geometry{BallShape{0.3}}, Geometry{BoxShape{vec(0.3, 0.3, 0.3)}}, Geometry{CapsuleShape{0.25, 0.3}});
  World world;
  add_table_with(world, thing, middle);
  Camera camera;
  camera.look(vec(-3, 6, 7), vec(0, 2, 0));
  const Vec3 light = key_light(), fallen = middle - light * ((middle[1] - 2.0) / light[1]);
  const LitAndShaded picture(world, camera, 4), quick(world, camera, 0);
  CHECK(picture.darker(fallen) > 25);
  CHECK(std::abs(picture.darker(vec(-1.2, 2, 1.2))) < 4);
  CHECK(quick.darker(fallen) == 0);
}

TEST_CASE("in pictures things hide the sky from what is near them", "[window]") {
  const Window window("test", 320, 180, true);
  World world;
  add_table_with(world, BoxShape{vec(0.4, 0.8, 0.4)}, vec(0, 2.8, 0));
  Camera camera;
  camera.look(vec(-3, 5, 7), vec(0, 2, 0));
  const LitAndShaded picture(world, camera, 4);
  CHECK(picture.darker(vec(-0.3, 2, 0.45)) > 6);  // at its foot, on the side of the light
  CHECK(picture.darker(vec(-0.3, 2, 0.45)) > picture.darker(vec(-0.5, 2, 1.2)) + 5);
}

TEST_CASE("in pictures a thin rod throws its shadow, however wide the box is that it is close above", "[window]") {
  const Window window("test", 320, 180, true);
  World world;
  add_shape(world, small_worlds::shape(BoxShape{vec(500, 1, 500)}, vec(0, -1, 0)));
  const double radius = 0.02, height = 0.1;
  add_shape(world, small_worlds::shape(CapsuleShape{radius, 0.5}, vec(0, height, 0)));
  Camera camera;
  camera.look(vec(0.1, 0.9, -0.2), vec(0, 0, 0));
  const LitAndShaded picture(world, camera, 4);
  const Vec3 light = key_light(), fallen = vec(-light[0], 0, -light[2]) * (height / light[1]);
  for (const double along : {-0.15, 0.0, 0.15}) {
    CAPTURE(along);
    CHECK(picture.darker(fallen + vec(0, 0, along)) > 8);
    CHECK(std::abs(picture.darker(fallen + vec(0.1, 0, along))) < 8);
  }
}

TEST_CASE("a sprite throws the shadow of what is opaque of it, of a card that stands upright", "[window]") {
  const Window window("test", 320, 180, true);
  World world;
  BodyDef def;
  def.at = vec(0, 2, 0);
  def.shapes = {small_worlds::shape(BallShape{0.5})};
  const auto half =
      pictured::picture(64, 64, [](double x, double) { return x < 0.5 ? pictured::red : pictured::clear; });
  def.sprite = std::make_shared<const Cover>(Cover{half, 2.0, zero3(), zero3()});
  add_body(world, def);
  ShapeDef floor = small_worlds::shape(HalfSpaceShape{});
  floor.orientation = quaternion_of(vec(1, 0, 0), -0.5 * std::numbers::pi);
  add_shape(world, floor);
  Camera camera;
  camera.look(vec(0, 6, 9), vec(0.5, 1, 0));
  const Vec3 light = key_light();
  for (const int samples : {0, 4}) {
    const LitAndShaded picture(world, camera, samples);
    const auto darker_below = [&](double right, double up) {
      const Vec3 of = vec(right, 2 + up, 0);
      return picture.darker(of - light * (of[1] / light[1]));
    };
    CAPTURE(samples);
    CHECK(darker_below(-0.5, 0) > 8);
    CHECK(darker_below(-0.5, 0.7) > 8);
    CHECK(std::abs(darker_below(0.5, 0)) < 4);
    CHECK(std::abs(darker_below(-0.5, 1.4)) < 4);
  }
}
