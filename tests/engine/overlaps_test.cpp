// What overlaps deeply is known, and what cannot leave is named.
#include "contacts/overlaps.hpp"

#include <catch2/catch.hpp>

#include "edit/edit.hpp"
#include "step/step.hpp"

using namespace pantin;
using Catch::Contains;

namespace {

BodyId put_lever(World& world, double x) {
  BodyDef lever;
  ShapeDef bar;
  bar.geometry = BoxShape{vec(0.2, 0.04, 0.04)};
  lever.shapes = {bar};
  lever.at = vec(x, 0, 0);
  lever.mass = 1.0;
  lever.name = "lever";
  PointDef pivot;
  pivot.at = vec(-0.2, 0, 0);
  lever.points = {pivot};
  return add_body(world, lever);
}

ShapeId put_wall(World& world, std::string layer = "") {
  ShapeDef wall;
  wall.geometry = BoxShape{vec(0.05, 0.5, 0.5)};
  wall.name = "wall";
  wall.layer = std::move(layer);
  return add_shape(world, wall);
}

std::vector<std::string> warnings(const World& world) {
  std::vector<std::string> list;
  for (const LogLine& line : world.log)
    if (line.kind == "warning") list.push_back(line.text);
  return list;
}

void advance(World& world, int steps) {
  for (int i = 0; i < steps; i++) step(world);
}

}  // namespace

TEST_CASE("overlaps: a lever whose nail is 2 cm within a wall is named once, with the depth and what to do") {
  World world;
  const ShapeId wall = put_wall(world);
  const BodyId lever = put_lever(world, 0.23);
  add_nail(world, world.bodies[lever].points[0]);
  advance(world, 2);
  CHECK(world.contacts.deepest.depth == Approx(0.02).epsilon(0.01));
  CHECK(world.contacts.deepest.part == Approx(0.25).epsilon(0.01));
  CHECK(world.contacts.deepest.pair == TouchPair{lever, wall});
  CHECK(warnings(world).empty());
  advance(world, 300);
  REQUIRE(warnings(world).size() == 1);
  CHECK_THAT(warnings(world)[0], Contains("'lever' overlaps") && Contains("'wall' by 0.02 m since it was put there") &&
                                     Contains("scene:collide"));
  CHECK(world.contacts.put.empty());
  set_layer(world, wall, "wall");  // an edit, which looks anew
  advance(world, 300);
  CHECK(warnings(world).size() == 1);
}

TEST_CASE("overlaps: what is let through, or pushed out, is not named") {
  World world;
  put_wall(world, "wall");
  const BodyId lever = put_lever(world, 0.23);
  add_nail(world, world.bodies[lever].points[0]);
  set_layer(world, world.bodies[lever].shapes[0], "lever");
  LayerRule rule;
  rule.collide = false;
  set_rule(world, "lever", "wall", rule);
  put_lever(world, 3.0);
  const BodyId free = put_lever(world, 3.35);
  advance(world, 5);
  CHECK(world.contacts.deepest.depth == Approx(0.05).epsilon(0.02));
  CHECK((world.contacts.deepest.pair.a == AnyId(free) || world.contacts.deepest.pair.b == AnyId(free)));
  advance(world, 400);
  CHECK(world.contacts.put.empty());
  CHECK(warnings(world).empty());
}

TEST_CASE("overlaps: what rests as it should is not deep") {
  World world;
  ShapeDef floor;
  floor.geometry = BoxShape{vec(5, 0.5, 5)};
  floor.at = vec(0, -0.54, 0);
  add_shape(world, floor);
  put_lever(world, 0.0);
  advance(world, 300);
  CHECK(world.contacts.deepest.part == 0.0);
  CHECK(world.contacts.put.empty());
}
