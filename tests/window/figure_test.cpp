#include "view/figure.hpp"

#include <catch2/catch.hpp>

#include "shapes/hull.hpp"
#include "shapes/mass.hpp"
#include "shapes/mesh.hpp"
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

namespace {

/// What a closed surface holds [m³], its triangles anticlockwise from outside.
double volume_in(const Figure& figure) {
  double sum = 0.0;
  for (std::size_t i = 0; i < figure.corners.size(); i += 3)
    sum += dot(figure.corners[i].at, cross(figure.corners[i + 1].at, figure.corners[i + 2].at)) / 6.0;
  return sum;
}

ShapeDef turned(Geometry geometry) {
  ShapeDef def = small_worlds::shape(std::move(geometry), vec(1, 2, 3));
  def.orientation = normalised({0.8, 0.3, -0.2, 0.4});
  return def;
}

}  // namespace

TEST_CASE("shapes are drawn as they are, whatever the points of their body", "[view]") {
  const std::vector<Vec3> corners = {vec(0, 0, 0), vec(1, 0, 0), vec(0, 2, 0), vec(0, 0, 3), vec(1, 1, 1)};
  for (const Geometry& geometry :
       {Geometry{BoxShape{vec(0.5, 1.0, 1.5)}}, Geometry{CylinderShape{0.5, 1.0}}, Geometry{make_hull(corners)}}) {
    BodyDef def;
    def.points = {weight(vec(0, 0, 0)), weight(vec(5, 0, 0))};
    def.shapes = {turned(geometry)};
    def.mass = 1.0;
    const Figure figure = figure_of(def);
    CHECK(figure.bars.empty());
    CHECK(volume_in(figure) == Approx(solid_mass(geometry).volume).epsilon(0.01));
    for (std::size_t i = 0; i < figure.corners.size(); i += 3) {
      const Vec3 area =
          cross(figure.corners[i + 1].at - figure.corners[i].at, figure.corners[i + 2].at - figure.corners[i].at);
      for (std::size_t k = i; k < i + 3; k++) {
        CHECK(norm(figure.corners[k].normal) == Approx(1.0));
        CHECK(dot(area, figure.corners[k].normal) > 0.99 * norm(area));
      }
    }
  }
  BodyDef def;
  def.shapes = {turned(BallShape{0.5}), turned(CapsuleShape{0.25, 1.0})};
  const Figure figure = figure_of(def);
  REQUIRE(figure.ellipsoids.size() == 1);
  CHECK(norm(figure.ellipsoids[0].axes[2]) == Approx(0.5));
  CHECK(norm(figure.ellipsoids[0].at - vec(1, 2, 3)) < 1e-12);
  REQUIRE(figure.bars.size() == 1);
  CHECK(norm(figure.bars[0].to - figure.bars[0].from) == Approx(2.0));
}

TEST_CASE("the front of a height field is its upper side", "[view]") {
  World world;
  const ShapeId hills = add_shape(world, small_worlds::shape(make_height_field(3, 2, 0.5, {0, 1, 0, 0.5, 0, 2})));
  const Figure figure = make_figure(world, hills);
  CHECK(figure.corners.size() == 12);
  for (std::size_t i = 0; i < figure.corners.size(); i += 3)
    CHECK(cross(figure.corners[i + 1].at - figure.corners[i].at, figure.corners[i + 2].at - figure.corners[i].at)[1] >
          0.0);
  const ShapeId plane = add_shape(world, small_worlds::shape(HalfSpaceShape{}));
  CHECK(make_figure(world, plane).corners.empty());
}
