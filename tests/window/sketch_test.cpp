#include "view/sketch.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "laws/course.hpp"
#include "support/allocations.hpp"
#include "window/small_worlds.hpp"

using namespace pantin;

TEST_CASE("a sketch of a chain has a bar for each rod, a ball for each hinge and the nail", "[view]") {
  const double size = GENERATE(1e-9, 1.0, 1e6);
  World world;
  small_worlds::chain(world, 5, size);
  const Stage stage = find_stage(world);
  Sketcher sketcher;
  Sketch sketch;
  sketcher.draw(world, first_camera(stage, 1.6), stage, {}, 720, sketch);
  CHECK(sketch.bars.size() == 5);
  CHECK(sketch.balls.size() == 5);
  CHECK(sketch.balls[0].style == 1.0f);
  CHECK(sketch.balls[0].radius > sketch.bars[0].radius);
  CHECK(sketch.lower.x < sketch.upper.x);
  CHECK(sketch.upper.x < 10.0f);  // in units of the camera's distance
}

TEST_CASE("nothing is allocated for a picture once the first is drawn", "[view]") {
  World world;
  small_worlds::chain(world, 50);
  const Stage stage = find_stage(world);
  const Camera camera = first_camera(stage, 1.6);
  const Overlay overlay;
  Sketcher sketcher;
  Sketch sketch;
  sketcher.draw(world, camera, stage, overlay, 720, sketch);
  const auto before = allocations();
  sketcher.draw(world, camera, stage, overlay, 720, sketch);
  CHECK(allocations() - before == 0);
}

TEST_CASE("a place that is not a number is left out", "[view]") {
  World world;
  const ParticleId particle = small_worlds::particle(world, vec(0, 1, 0));
  const Stage stage = find_stage(world);
  world.motion_of(world.particles[particle].points[0]).x = vec(std::nan(""), 0, 0);
  Sketcher sketcher;
  Sketch sketch;
  sketcher.draw(world, Camera{}, stage, {}, 720, sketch);
  CHECK(sketch.balls.empty());
}

TEST_CASE("a particle that glows is a disc of light, a streak a line against its velocity", "[view]") {
  World world;
  small_worlds::particle(world, vec(0, 1, 0));
  ParticleDef def;
  def.at = vec(1, 1, 0);
  def.radius = 0.2;
  def.color = Color{1.0f, 0.5f, 0.0f, 0.25f};
  def.look = Look::glow;
  add_particle(world, def);
  FamilyDef sparks;
  sparks.name = "sparks";
  sparks.look = Look::streak;
  def.family = add_family(world, sparks);
  def.look.reset();
  def.velocity = vec(0, 3, 0);
  add_particle(world, def);
  const Stage stage = find_stage(world);
  Sketcher sketcher;
  Sketch sketch;
  sketcher.draw(world, first_camera(stage, 1.6), stage, {}, 720, sketch);
  CHECK(sketch.balls.size() == 1);
  REQUIRE(sketch.glows.size() == 1);
  CHECK(sketch.glows[0].opacity == 0.25f);
  CHECK(sketch.glows[0].color.g == 0.5f);
  REQUIRE(sketch.streaks.size() == 1);
  CHECK(sketch.streaks[0].tail.y < sketch.streaks[0].head.y);
  CHECK(sketch.streaks[0].tail.x == sketch.streaks[0].head.x);
}

TEST_CASE("radius and color that follow the age are those of now; a radius of 0 is not drawn", "[view]") {
  World world;
  Expressions graph;
  const Expr age = graph.input(course_age);
  const Expr shrunk = graph.subtract(graph.constant(0.5), age);
  const Expr rgba[] = {age, graph.constant(0.5), graph.constant(0.0), graph.constant(1.0)};
  ParticleDef def;
  def.look = Look::glow;
  def.courses =
      with(with(nullptr, make_course("radius", graph, {&shrunk, 1})).get(), make_course("color", graph, rgba));
  add_particle(world, def);
  const Stage stage = find_stage(world);
  const Camera camera = first_camera(stage, 1.6);
  Sketcher sketcher;
  Sketch sketch;
  world.time = 0.25;
  sketcher.draw(world, camera, stage, {}, 720, sketch);
  REQUIRE(sketch.glows.size() == 1);
  CHECK(sketch.glows[0].color.r == 0.25f);
  CHECK(static_cast<double>(sketch.glows[0].radius) * camera.distance == Approx(0.25));
  world.time = 0.75;
  sketcher.draw(world, camera, stage, {}, 720, sketch);
  CHECK(sketch.glows.empty());
}
