#include "view/stage.hpp"

#include <catch2/catch.hpp>

#include "edit/coupling_constraints.hpp"
#include "edit/emitter.hpp"
#include "support/library_laws.hpp"
#include "window/small_worlds.hpp"

using namespace pantin;

TEST_CASE("the stage of a chain holds it where it hangs, with the ground below", "[view]") {
  const double size = GENERATE(1e-9, 1.0, 1e6);
  World world;
  small_worlds::chain(world, 5, size);
  const Stage stage = find_stage(world);
  CHECK(stage.unit == Approx(size));
  CHECK(stage.lower[1] == Approx(-size));
  CHECK(stage.upper[0] == Approx(5 * size));
  CHECK(stage.lower[0] == Approx(-5 * size));
  CHECK(stage.ground < -size);
}

TEST_CASE("a top stands on the ground", "[view]") {
  World world;
  small_worlds::top(world);
  CHECK(find_stage(world).ground == 0.0);
}

TEST_CASE("an empty world, one particle and a cloud have sizes too", "[view]") {
  World world;
  CHECK(find_stage(world).empty);
  CHECK(find_stage(world).size > 0.0);
  small_worlds::particle(world, vec(1, 2, 3));
  CHECK(find_stage(world).size > 0.0);
  CHECK_FALSE(find_stage(world).empty);
  for (int i = 1; i < 50; i++) small_worlds::particle(world, vec(1 + 0.25 * i, 2, 3));
  CHECK(find_stage(world).unit == Approx(0.25));
}

TEST_CASE("the first camera sees the whole stage", "[view]") {
  World world;
  small_worlds::chain(world, 5);
  const Stage stage = find_stage(world);
  const Camera camera = first_camera(stage, 1280.0 / 720.0);
  for (const Vec3 corner : {stage.lower, stage.upper}) {
    const auto seen = camera.project(corner, 1280, 720);
    REQUIRE(seen);
    CHECK(seen->x > 0.0);
    CHECK(seen->x < 1280.0);
    CHECK(seen->y > 0.0);
    CHECK(seen->y < 720.0);
  }
}

TEST_CASE("the stage of an emitter holds what it will make", "[view]") {
  World world;
  EmitterDef def;
  def.position.at = vec(0, 2, 0);
  def.rate = 10;
  def.velocity = vec(3, 0, 0);
  def.shortest = def.longest = 0.5;
  add_emitter(world, def);
  const Stage stage = find_stage(world);
  CHECK_FALSE(stage.empty);
  CHECK(stage.upper[0] == Approx(1.5));
  CHECK(stage.upper[1] == Approx(2.0));
  CHECK(stage.lower[1] == Approx(2.0 - 0.5 * 9.81 * 0.25));
}

TEST_CASE("the stage of what hangs by springs reaches as far down as they do", "[view]") {
  World world;
  std::vector<ParticleId> knots;
  for (int i = 0; i < 6; i++) knots.push_back(small_worlds::particle(world, vec(i, 4, 0)));
  add_nail(world, world.particles[knots[0]].points[0]);
  const auto law = std::make_shared<Law>(testing::make("spring", {{"stiffness", 1.0}, {"length", 1.0}})[0]);
  for (std::size_t i = 1; i < 6; i++) {
    ConnectionDef def;
    def.ends = {{knots[i - 1]}, {knots[i]}};
    add_connection(world, law, def);
  }
  const Stage stage = find_stage(world);
  CHECK(stage.lower[1] == Approx(-1.0));
  CHECK(stage.ground < -1.0);
}

TEST_CASE("the stage holds shapes, what is near of the world's, and stands on a floor", "[view]") {
  World world;
  BodyDef def;
  def.at = vec(0, 2, 0);
  def.shapes = {small_worlds::shape(BoxShape{vec(1, 2, 0.5)})};
  add_body(world, def);
  CHECK(find_stage(world).lower[1] == Approx(0.0).margin(1e-12));
  CHECK(find_stage(world).upper[1] == Approx(4.0));
  CHECK(find_stage(world).unit == Approx(std::sqrt(21.0)));
  add_shape(world, small_worlds::shape(BoxShape{vec(50, 0.5, 50)}, vec(0, -0.5, 0)));
  CHECK(find_stage(world).upper[0] == Approx(3.0));
  CHECK(find_stage(world).lower[1] == Approx(-1.0));
  ShapeDef floor = small_worlds::shape(HalfSpaceShape{}, vec(0, -1.5, 0));
  floor.orientation = normalised({1.0, -1.0, 0.0, 0.0});
  add_shape(world, floor);
  CHECK(find_stage(world).ground == -1.5);
}

TEST_CASE("the stage has what a rope is held by, and the way that something is on", "[view]") {
  World world;
  const ParticleId a = small_worlds::particle(world, vec(0, 0, 0)), b = small_worlds::particle(world, vec(1, 0, 0));
  add_pulley(world, world.particles[a].points[0], {{}, vec(0, 3, 0)}, world.particles[b].points[0], {{}, vec(1, 3, 0)});
  CHECK(find_stage(world).upper[1] == 3.0);
}
