#include "view/figure.hpp"

#include <catch2/catch.hpp>

#include "window/small_worlds.hpp"

using namespace pantin;

namespace {

PointDef weight(Vec3 at) {
  PointDef def = small_worlds::anchor(at);
  def.mass = 1.0;
  return def;
}

Figure figure_of(const BodyDef& def) {
  World world;
  const BodyId body = add_body(world, def);
  return make_figure(world, body, find_stage(world));
}

}  // namespace

TEST_CASE("points on a line become a capsule from end to end, with its weights as balls", "[view]") {
  const double size = GENERATE(1e-9, 1.0, 1e6);
  BodyDef def;
  def.points = {weight(vec(0, 0, 0)), weight(vec(2, 2, 0) * size), weight(vec(1, 1, 0) * size)};
  const Figure figure = figure_of(def);
  REQUIRE(figure.bars.size() == 1);
  const double length = norm(figure.bars[0].from - figure.bars[0].to);
  CHECK(length / size == Approx(std::sqrt(8.0)));
  CHECK(figure.bars[0].radius < 0.1 * length);
  CHECK(figure.bars[0].radius > 0.01 * length);
  CHECK(figure.balls.size() == 3);
  CHECK(figure.corners.empty());
}

TEST_CASE("a slender inertia gives the capsule its radius, a wide one an ellipsoid about its axis", "[view]") {
  BodyDef def;
  def.mass = 1.0;
  def.points = {small_worlds::anchor(vec(0, -0.5, 0)), small_worlds::anchor(vec(0, 0.5, 0))};
  const double radius = 0.06;
  def.inertia = diagonal(vec(1.0 / 12.0, radius * radius / 2.0, 1.0 / 12.0));
  CHECK(figure_of(def).bars.at(0).radius == Approx(radius).epsilon(0.05));
  CHECK(figure_of(def).ellipsoids.empty());
  def.inertia = diagonal(vec(0.05, 0.08, 0.05));
  const Figure top = figure_of(def);
  REQUIRE(top.ellipsoids.size() == 1);
  CHECK(norm(cross(top.ellipsoids[0].axes[1], vec(0, 1, 0))) < 1e-12);
  CHECK(norm(top.ellipsoids[0].axes[0]) == Approx(std::sqrt(2.5 * 0.08)));
}

TEST_CASE("points in a plane become a plate, in space their hull", "[view]") {
  BodyDef def;
  for (int i = 0; i < 4; i++) def.points.push_back(weight(vec(i & 1, i >> 1, 0)));
  CHECK(figure_of(def).corners.size() == 3 * 12);
  def.points.push_back(weight(vec(0, 0, 1)));
  CHECK(figure_of(def).corners.size() == 3 * 6);
  CHECK(figure_of(def).bars.empty());
}

TEST_CASE("a body of one point is a ball", "[view]") {
  BodyDef def;
  def.points = {weight(vec(1, 2, 3))};
  const Figure figure = figure_of(def);
  REQUIRE(figure.balls.size() == 1);
  CHECK(figure.balls[0].radius > 0.0);
  CHECK(same(figure.balls[0].at, vec(1, 2, 3)));
}

TEST_CASE("a figure is made anew when its body changes", "[view]") {
  World world;
  BodyDef def;
  def.points = {weight(vec(0, 0, 0)), weight(vec(1, 0, 0))};
  const BodyId body = add_body(world, def);
  const Stage stage = find_stage(world);
  Figures figures;
  CHECK(figures.of(world, body, stage).bars.size() == 1);
  CHECK(&figures.of(world, body, stage) == &figures.of(world, body, stage));
  add_point(world, body, weight(vec(0, 1, 0)));
  CHECK(figures.of(world, body, stage).bars.empty());
  CHECK_FALSE(figures.of(world, body, stage).corners.empty());
}
