#include "shapes/hull.hpp"

#include <catch2/catch.hpp>
#include <numbers>

#include "base/check.hpp"
#include "support/brute_shapes.hpp"

using namespace pantin;

namespace {

std::vector<Vec3> cube_corners(double half) {
  std::vector<Vec3> corners;
  for (int i = 0; i < 8; i++) corners.push_back(vec(i & 1 ? half : -half, i & 2 ? half : -half, i & 4 ? half : -half));
  return corners;
}

/// Corners run anticlockwise from outside, nothing is beyond a face, and Euler's count holds.
void check_hull(const Hull& hull, double accepted) {
  CHECK(hull.vertices.size() + hull.faces.size() == hull.edges.size() + 2);
  for (const Hull::Face& face : hull.faces) {
    CHECK(norm(face.normal) == Approx(1.0).epsilon(1e-15));
    for (const Vec3 v : hull.vertices) CHECK(dot(face.normal, v) <= face.offset + accepted);
    for (std::uint32_t i = 0; i < face.count; i++) {
      const auto corner = [&](std::uint32_t k) { return hull.vertices[hull.loops[face.first + k % face.count]]; };
      CHECK(std::fabs(dot(face.normal, corner(i)) - face.offset) <= accepted);
      CHECK(dot(face.normal, cross(corner(i + 1) - corner(i), corner(i + 2) - corner(i + 1))) > 0.0);
    }
  }
}

}  // namespace

TEST_CASE("hull: of a cube's corners and points within has six faces of four corners and twelve edges") {
  std::vector<Vec3> points = cube_corners(0.5);
  points.push_back(zero3());
  points.push_back(vec(0.5, 0.1, 0.2));
  const auto hull = make_hull(points);
  CHECK(hull->vertices.size() == 8);
  CHECK(hull->faces.size() == 6);
  CHECK(hull->edges.size() == 12);
  check_hull(*hull, 0.0);
  CHECK(hull->thickness == 1.0);
  CHECK(hull->reach == std::sqrt(0.75));
}

TEST_CASE("hull: coplanar corners of a turned prism are one face") {
  Random random;
  const Mat3 R = brute::random_turn(random);
  std::vector<Vec3> points;
  for (int i = 0; i < 8; i++) {
    const double angle = i * std::numbers::pi / 4;
    for (const double z : {-0.3, 0.3}) points.push_back(R * vec(std::cos(angle), std::sin(angle), z));
  }
  const auto hull = make_hull(points);
  CHECK(hull->faces.size() == 10);
  CHECK(hull->edges.size() == 24);
  check_hull(*hull, 1e-15);
}

TEST_CASE("hull: random points of any size give closed polyhedra, and their farthest vertices") {
  Random random;
  for (const double size : {1e-6, 1.0, 1e3})
    for (const std::size_t count : {4u, 9u, 40u}) {
      const auto hull = make_hull(brute::random_points(random, count, size));
      CHECK(hull->vertices.size() == count);
      check_hull(*hull, 1e-15 * size);
      for (int i = 0; i < 20; i++) {
        const Vec3 d = brute::random_direction(random);
        double most = -infinity;
        for (const Vec3 v : hull->vertices) most = std::max(most, dot(d, v));
        CHECK(dot(d, hull->vertices[farthest(*hull, d)]) == most);
      }
    }
}

TEST_CASE("hull: each edge has its two faces, and each vertex its neighbours") {
  Random random;
  const auto hull = make_hull(brute::random_points(random, 12, 1.0));
  for (std::size_t i = 0; i < hull->edges.size(); i++)
    for (const std::uint32_t f : hull->edge_faces[i])
      for (const std::uint32_t v : hull->edges[i]) {
        const Hull::Face& face = hull->faces[f];
        CHECK(std::fabs(dot(face.normal, hull->vertices[v]) - face.offset) < 1e-15);
      }
}

TEST_CASE("hull: points too few, in a plane, at one place or not finite are refused") {
  const auto refused = [](std::vector<Vec3> points, const char* part) {
    CHECK_THROWS_WITH(make_hull(points), Catch::Contains(part));
  };
  refused({vec(0, 0, 0), vec(1, 0, 0), vec(0, 1, 0)}, "3 points");
  refused({vec(0, 0, 0), vec(1, 0, 0), vec(0, 1, 0), vec(1, 1, 0), vec(3, 2, 0)}, "plane");
  refused({vec(0, 0, 0), vec(1, 0, 0), vec(0, 1, 0), vec(1, 1, 1e-13)}, "plane");
  refused(std::vector<Vec3>(6, vec(1, 2, 3)), "within 0 m");
  refused({vec(0, 0, 0), vec(1, 0, 0), vec(0, 1, 0), vec(0, 0, std::nan(""))}, "Point 4");
  refused({vec(0, 0, 0), vec(1, 0, 0), vec(0, infinity, 0), vec(0, 0, 1)}, "Point 3");
}
