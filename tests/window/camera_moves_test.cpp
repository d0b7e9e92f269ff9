#include "view/camera_moves.hpp"

#include <catch2/catch.hpp>

#include "edit/edit.hpp"
#include "measure/query.hpp"
#include "view/stage.hpp"
#include "window/small_worlds.hpp"

using namespace pantin;

TEST_CASE("all that plays is framed with the walls and the floor beside it", "[view]") {
  World world;
  for (const double x : {-7.0, 7.0})
    add_shape(world, small_worlds::shape(BoxShape{vec(0.15, 1.5, 0.5)}, vec(x, 1.5, 0)));
  for (int i = -5; i <= 5; i++) small_worlds::particle(world, vec(i, 1, 0));
  const Stage stage = find_stage(world);
  for (const ParticleId id : particles(world))
    if (std::fabs(position(world, world.particles[id].points[0])[0]) > 1.5) remove(world, id);
  Camera camera;
  see_all(world, stage, 16.0 / 9.0, camera);
  for (const Vec3 corner : {vec(-7, 0, 0), vec(-7, 3, 0), vec(7, 0, 0), vec(7, 3, 0)}) {
    const auto seen = camera.project(corner, 1280, 720);
    REQUIRE(seen);
    CHECK((seen->x > 0.0 && seen->x < 1280.0 && seen->y > 0.0 && seen->y < 720.0));
  }
}

TEST_CASE("of ground that goes on for long only what is near is framed", "[view]") {
  World world;
  add_shape(world, small_worlds::shape(BoxShape{vec(1000, 1, 5)}, vec(0, -1, 0)));
  for (int i = 0; i < 3; i++) small_worlds::particle(world, vec(300 + i, 1, 0));
  const Stage stage = find_stage(world);
  Camera camera;
  see_all(world, stage, 16.0 / 9.0, camera);
  CHECK(camera.distance < 20.0);
  CHECK(camera.target[0] == Approx(301).margin(1));
}
