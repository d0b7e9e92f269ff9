#include "view/pick.hpp"

#include <catch2/catch.hpp>

#include "window/small_worlds.hpp"

using namespace pantin;

namespace {

constexpr int width = 1280, height = 720;

}  // namespace

TEST_CASE("the point under a pixel is found, at any size of scene", "[view]") {
  const double size = GENERATE(1e-9, 1.0, 1e6);
  World world;
  const auto rods = small_worlds::chain(world, 4, size);
  const Stage stage = find_stage(world);
  const Camera camera = first_camera(stage, 1280.0 / 720.0);
  const PointId tail = world.bodies[rods[3]].points[1], joint = world.bodies[rods[1]].points[1];
  const auto end = camera.project(position(world, tail), width, height);
  REQUIRE(end);
  CHECK(pick_point(world, stage, camera, end->x + 6, end->y - 5, width, height) == tail);
  CHECK_FALSE(pick_hinge(world, stage, camera, end->x + 6, end->y - 5, width, height));
  const auto middle = camera.project(position(world, joint), width, height);
  const ParticleId hinge = world.points[joint].particle;
  CHECK(pick_hinge(world, stage, camera, middle->x + 3, middle->y, width, height) == hinge);
  CHECK(world.points[pick_point(world, stage, camera, middle->x + 3, middle->y, width, height)].particle == hinge);
  CHECK_FALSE(pick_point(world, stage, camera, 5, height - 5, width, height));
}

TEST_CASE("of two points at one pixel the nearer to the eye is picked, and none behind the eye", "[view]") {
  World world;
  const ParticleId far_one = small_worlds::particle(world, vec(0, 0, -2));
  const ParticleId near_one = small_worlds::particle(world, vec(0, 0, 2));
  small_worlds::particle(world, vec(0, 0, 9));
  Camera camera;
  camera.look(vec(0, 0, 6), zero3());
  const Stage stage = find_stage(world);
  CHECK(pick_point(world, stage, camera, 640, 360, width, height) == world.particles[near_one].points[0]);
  remove(world, near_one);
  CHECK(pick_point(world, stage, camera, 640, 360, width, height) == world.particles[far_one].points[0]);
}

TEST_CASE("the body or the ground that is seen at a pixel is picked, through sensors", "[view]") {
  World world;
  CHECK(std::holds_alternative<std::monostate>(pick_shape(world, Camera{}, 640, 360, width, height)));
  ShapeDef shape;
  shape.geometry = BoxShape{vec(1, 1, 1)};
  BodyDef def;
  def.shapes = {shape};
  const BodyId body = add_body(world, def);
  shape.at = vec(4, 0, 0);
  const ShapeId ground = add_shape(world, shape);
  shape.at = vec(2, 0, 3);
  shape.geometry = BoxShape{vec(9, 9, 0.1)};
  shape.sensor = true;
  add_shape(world, shape);
  Camera camera;
  camera.look(vec(0, 0, 20), zero3());
  CHECK(pick_shape(world, camera, 640, 360, width, height) == AnyId(body));
  const auto beside = camera.project(vec(4, 0.5, 0), width, height);
  CHECK(pick_shape(world, camera, beside->x, beside->y, width, height) == AnyId(ground));
  CHECK(std::holds_alternative<std::monostate>(pick_shape(world, camera, 5, 5, width, height)));
}
