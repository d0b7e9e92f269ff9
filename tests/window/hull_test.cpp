#include "view/hull.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

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

TEST_CASE("points in a plane, on a line or at one position have no hull", "[view]") {
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

TEST_CASE("the hull of a round plate of a thousand points is as large as the plate, however its points are shaken",
          "[view]") {
  constexpr int around = 500;
  const double thick = 0.04, shake = GENERATE(0.0, 1e-11, 4e-9, 1e-6);
  const Vec3 up = direction(vec(0.3, 0.5, 0.1)), x = direction(cross(up, vec(0, 0, 1))), y = cross(up, x);
  const auto shaken = [&](int i) { return vec(std::sin(17.0 * i), std::cos(31.0 * i), std::sin(53.0 * i)) * shake; };
  std::vector<Vec3> points = {zero3(), up * thick};  // the middles of both faces
  for (int i = 0; i < 2 * around; i++) {
    const double angle = 2.0 * std::numbers::pi * i / around;
    points.push_back(x * std::cos(angle) + y * std::sin(angle) + up * (i < around ? 0.0 : thick) + shaken(i));
  }
  const double area = 0.5 * around * std::sin(2.0 * std::numbers::pi / around);
  CHECK(convex_hull(points).size() <= 4 * around);
  CHECK(volume(points) == Approx(area * thick).epsilon(1e-4));
  if (shake == 0.0) CHECK(convex_hull(points).size() == 4 * around - 4);
}
