#include "view/hull.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace pantin;

namespace {

double volume(const std::vector<Vec3>& points) {
  double sum = 0.0;
  for (const auto& f : convex_hull(points)) sum += dot(points[f[0]], cross(points[f[1]], points[f[2]])) / 6.0;
  return sum;
}

std::vector<Vec3> cube(double size) {
  std::vector<Vec3> points;
  for (int i = 0; i < 8; i++) points.push_back(vec(i & 1, (i >> 1) & 1, i >> 2) * size + vec(5, 6, 7) * size);
  return points;
}

}  // namespace

TEST_CASE("the hull of a cube has twelve triangles that face outward, at any size", "[view]") {
  const double size = GENERATE(1e-9, 1.0, 1e6);
  std::vector<Vec3> points = cube(size);
  CHECK(convex_hull(points).size() == 12);
  CHECK(volume(points) / (size * size * size) == Approx(1.0));
  points.push_back(vec(5.5, 6.5, 7.5) * size);  // inside
  points.push_back(points[0]);                  // twice
  CHECK(convex_hull(points).size() == 12);
}

TEST_CASE("points in a plane, on a line or in one place have no hull", "[view]") {
  CHECK(convex_hull(std::vector<Vec3>{vec(0, 0, 0), vec(1, 0, 0), vec(0, 1, 0), vec(1, 1, 0)}).empty());
  CHECK(convex_hull(std::vector<Vec3>{vec(0, 0, 0), vec(1, 1, 1), vec(2, 2, 2), vec(3, 3, 3)}).empty());
  CHECK(convex_hull(std::vector<Vec3>(5, vec(1, 2, 3))).empty());
  CHECK(convex_hull(std::vector<Vec3>{vec(0, 0, 0), vec(1, 0, 0), vec(0, 1, 0)}).empty());
}

TEST_CASE("every point of a cloud is inside its hull", "[view]") {
  std::vector<Vec3> points;
  for (int i = 0; i < 200; i++) {
    const double a = 0.7 * i, b = 1.3 * i * i;
    points.push_back(vec(a - std::floor(a), b - std::floor(b), 0.5 + 0.5 * std::sin(3.1 * i)));
  }
  const auto faces = convex_hull(points);
  REQUIRE(faces.size() >= 4);
  for (const auto& f : faces) {
    const Vec3 normal = direction(cross(points[f[1]] - points[f[0]], points[f[2]] - points[f[0]]));
    for (const Vec3 p : points) CHECK(dot(normal, p - points[f[0]]) < 1e-6);
  }
}
