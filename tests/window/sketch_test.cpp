#include "view/sketch.hpp"

#include <catch2/catch.hpp>
#include <cmath>

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
