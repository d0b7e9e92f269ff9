#include "view/draw_list.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "laws/curve.hpp"
#include "laws/law.hpp"
#include "support/allocations.hpp"
#include "view/pick.hpp"
#include "window/small_worlds.hpp"

using namespace pantin;

TEST_CASE("a draw_list of a chain has a bar for each rod, a ball for each hinge and the nail", "[view]") {
  const double size = GENERATE(1e-9, 1.0, 1e6);
  World world;
  small_worlds::chain(world, 5, size);
  const Stage stage = find_stage(world);
  DrawListMaker draw_list_maker;
  DrawList draw_list;
  draw_list_maker.draw(world, first_camera(stage, 1.6), stage, {}, 720, draw_list);
  CHECK(draw_list.bars.size() == 5);
  CHECK(draw_list.balls.size() == 5);
  CHECK(draw_list.balls[0].style == 1.0f);
  CHECK(draw_list.balls[0].radius > draw_list.bars[0].radius);
  CHECK(draw_list.lower.x < draw_list.upper.x);
  CHECK(draw_list.upper.x < 10.0f);  // in units of the camera's distance
}

TEST_CASE("a floor without a size is drawn where the camera looks, one with a size where it is", "[view]") {
  World world;
  ShapeDef def;
  def.geometry = HalfSpaceShape{};
  add_shape(world, def);
  def.extent = 3.0;
  add_shape(world, def);
  const Stage stage = find_stage(world);
  Camera camera = first_camera(stage, 1.6);
  DrawListMaker draw_list_maker;
  DrawList draw_list;
  for (const double away : {0.0, 100.0}) {
    camera.target = vec(away, 0, 0);
    draw_list_maker.draw(world, camera, stage, {}, 720, draw_list);
    REQUIRE(draw_list.floors.size() == 2);
    const auto from_target = [&](const DrawList::Floor& f) {
      return double{f.middle.x} * camera.distance + camera.eye()[0] - away;
    };
    CHECK(std::fabs(from_target(draw_list.floors[0])) < 0.5 * camera.distance * double{draw_list.floors[0].reach});
    CHECK(std::fabs(from_target(draw_list.floors[1]) + away) < 1e-3);
  }
}

TEST_CASE("nothing is allocated for a picture once the first is drawn", "[view]") {
  World world;
  small_worlds::chain(world, 50);
  const Stage stage = find_stage(world);
  const Camera camera = first_camera(stage, 1.6);
  const Overlay overlay;
  DrawListMaker draw_list_maker;
  DrawList draw_list;
  draw_list_maker.draw(world, camera, stage, overlay, 720, draw_list);
  const auto before = allocations();
  draw_list_maker.draw(world, camera, stage, overlay, 720, draw_list);
  CHECK(allocations() - before == 0);
}

TEST_CASE("a position that is not a number is left out", "[view]") {
  World world;
  const ParticleId particle = small_worlds::particle(world, vec(0, 1, 0));
  const Stage stage = find_stage(world);
  world.motion_of(world.particles[particle].points[0]).x = vec(std::nan(""), 0, 0);
  DrawListMaker draw_list_maker;
  DrawList draw_list;
  draw_list_maker.draw(world, Camera{}, stage, {}, 720, draw_list);
  CHECK(draw_list.balls.empty());
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
  DrawListMaker draw_list_maker;
  DrawList draw_list;
  draw_list_maker.draw(world, first_camera(stage, 1.6), stage, {}, 720, draw_list);
  CHECK(draw_list.balls.size() == 1);
  REQUIRE(draw_list.glows.size() == 1);
  CHECK(draw_list.glows[0].opacity == 0.25f);
  CHECK(draw_list.glows[0].color.g == 0.5f);
  REQUIRE(draw_list.streaks.size() == 1);
  CHECK(draw_list.streaks[0].tail.y < draw_list.streaks[0].head.y);
  CHECK(draw_list.streaks[0].tail.x == draw_list.streaks[0].head.x);
}

TEST_CASE("radius and color that follow the age are those of now; a radius of 0 is not drawn", "[view]") {
  World world;
  Expressions graph;
  const Expr age = graph.input(curve_age);
  const Expr shrunk = graph.subtract(graph.constant(0.5), age);
  const Expr rgba[] = {age, graph.constant(0.5), graph.constant(0.0), graph.constant(1.0)};
  ParticleDef def;
  def.look = Look::glow;
  def.curves = with(with(nullptr, make_curve("radius", graph, {&shrunk, 1})).get(), make_curve("color", graph, rgba));
  add_particle(world, def);
  const Stage stage = find_stage(world);
  const Camera camera = first_camera(stage, 1.6);
  DrawListMaker draw_list_maker;
  DrawList draw_list;
  world.time = 0.25;
  draw_list_maker.draw(world, camera, stage, {}, 720, draw_list);
  REQUIRE(draw_list.glows.size() == 1);
  CHECK(draw_list.glows[0].color.r == 0.25f);
  CHECK(static_cast<double>(draw_list.glows[0].radius) * camera.distance == Approx(0.25));
  world.time = 0.75;
  draw_list_maker.draw(world, camera, stage, {}, 720, draw_list);
  CHECK(draw_list.glows.empty());
}

TEST_CASE("a break is shown where it was, fades, and is gone", "[view]") {
  World world;
  small_worlds::particle(world, zero3());
  world.breaks.push_back({vec(0, 1, 0), vec(2, 1, 0), 3.0});
  const Stage stage = find_stage(world);
  const Camera camera = first_camera(stage, 1.6);
  const auto draw = [&](double time, double pace) {
    world.time = time;
    Overlay overlay;
    overlay.pace = pace;
    DrawList draw_list;
    DrawListMaker().draw(world, camera, stage, overlay, 720, draw_list);
    return draw_list;
  };
  const DrawList fresh = draw(3.0, 1.0), old = draw(3.3, 1.0);
  REQUIRE(fresh.streaks.size() == 2);
  REQUIRE(fresh.glows.size() == 1);
  CHECK(fresh.glows[0].opacity == 1.0f);
  REQUIRE(old.glows.size() == 1);
  CHECK(old.glows[0].opacity < 0.5f);
  CHECK(draw(4.0, 1.0).glows.empty());
  CHECK(draw(4.0, 10.0).glows.size() == 1);
}

TEST_CASE("in a periodic box things are shown where the box has them, and ties between nearest images", "[view]") {
  World world;
  const ParticleId a = small_worlds::particle(world, vec(-0.5, 1, 1)),
                   b = small_worlds::particle(world, vec(10.5, 1, 1));
  Expressions graph;
  const Expr energy = graph.input({Role::distance2, 0, 0, {}});
  ConnectionDef def;
  def.ends = {{a}, {b}};
  add_connection(world, std::make_shared<Law>(central_potential({.name = "tie"}, graph, energy)), def);
  set_box(world, vec(10, 10, 10));
  const PointId point = world.particles[a].points[0];
  CHECK(shown_place(world, point)[0] == 9.5);
  const Stage stage = find_stage(world);
  Camera camera = first_camera(stage, 1.6);
  camera.frame(zero3(), vec(10, 10, 10), 1.6);
  DrawList draw_list;
  DrawListMaker().draw(world, camera, stage, {}, 720, draw_list);
  REQUIRE(draw_list.bars.size() == 1);
  CHECK(static_cast<double>(draw_list.bars[0].to.x - draw_list.bars[0].from.x) * camera.distance ==
        Approx(1.0).epsilon(1e-4));
  const auto seen = camera.project(vec(9.5, 1, 1), 1152, 720);
  CHECK(pick_point(world, stage, camera, seen->x, seen->y, 1152, 720) == point);
}
