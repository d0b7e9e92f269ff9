#include "shapes/mass.hpp"

#include <catch2/catch.hpp>
#include <numbers>

#include "base/check.hpp"
#include "shapes/hull.hpp"
#include "shapes/shape.hpp"
#include "support/brute_shapes.hpp"

using namespace pantin;

namespace {

void check_same(const Mat3& a, const Mat3& b, double accepted) {
  for (int i = 0; i < 3; i++) CHECK(largest(a[i] - b[i]) <= accepted);
}

/// Rings of points on a body of revolution about z.
template <class Radius>
Geometry turned(Radius radius, double low, double high, int rings, int around) {
  std::vector<Vec3> points;
  for (int i = 0; i <= rings; i++) {
    const double z = 0.5 * (low + high) - 0.5 * (high - low) * std::cos(i * std::numbers::pi / rings);
    for (int k = 0; k < around; k++) {
      const double angle = 2 * std::numbers::pi * k / around;
      points.push_back(vec(radius(z) * std::cos(angle), radius(z) * std::sin(angle), z));
    }
  }
  return make_hull(points);
}

void check_near(const Geometry& shape, const Geometry& hull, double part) {
  const SolidMass exact = solid_mass(shape), near = solid_mass(hull);
  CHECK(near.volume == Approx(exact.volume).epsilon(part));
  check_same(near.second, exact.second, part * largest(exact.second[0] + exact.second[2]));
  CHECK(norm(near.centre) < 1e-12);
}

}  // namespace

TEST_CASE("mass: a box's closed form is that of the hull of its corners") {
  const BoxShape box{vec(0.5, 1.0, 0.25)};
  std::vector<Vec3> corners;
  for (int i = 0; i < 8; i++) corners.push_back(box.half * vec(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
  check_near(box, make_hull(corners), 1e-15);
  CHECK(solid_mass(box).volume == 1.0);
  CHECK(solid_mass(box).second[0][0] == Approx((4.0 + 0.25) / 12.0).epsilon(1e-15));
}

TEST_CASE("mass: closed forms of round shapes are those of hulls of many points") {
  check_near(BallShape{0.7}, turned([](double z) { return std::sqrt(std::max(0.0, 0.49 - z * z)); }, -0.7, 0.7, 24, 40),
             2e-2);
  check_near(CylinderShape{0.7, 0.4}, turned([](double) { return 0.7; }, -0.4, 0.4, 1, 200), 1e-3);
  const auto capsule = [](double z) {
    const double past = std::max(0.0, std::fabs(z) - 0.4);
    return std::sqrt(std::max(0.0, 0.09 - past * past));
  };
  check_near(CapsuleShape{0.3, 0.4}, turned(capsule, -0.7, 0.7, 30, 40), 2e-2);
}

TEST_CASE("mass: a long thin capsule and a short wide one have moments of their parts, worked out by hand") {
  const double pi = std::numbers::pi;
  const SolidMass mass = solid_mass(CapsuleShape{1.0, 2.0});
  CHECK(mass.volume == Approx(4 * pi + 4 * pi / 3).epsilon(1e-15));
  CHECK(mass.second[2][2] == Approx(2 * pi + 8 * pi / 15).epsilon(1e-15));
  const double ends = 4 * pi / 3, side = 4 * pi;
  const double half_ball = ends / 2 * (0.4 - 9.0 / 64.0);
  CHECK(mass.second[0][0] ==
        Approx(side * (0.25 + 4.0 / 3.0) + 2 * (half_ball + ends / 2 * (2.375 * 2.375))).epsilon(1e-15));
}

TEST_CASE("mass: a turned and moved tetrahedron has the turned inertia about its moved centre") {
  Random random;
  const std::vector<Vec3> own{vec(0, 0, 0), vec(1, 0, 0), vec(0, 1, 0), vec(0, 0, 1)};
  const SolidMass before = solid_mass(make_hull(own));
  CHECK(before.volume == Approx(1.0 / 6.0).epsilon(1e-15));
  CHECK(norm(before.centre - vec(0.25, 0.25, 0.25)) < 1e-15);
  // Of a corner of a unit cube about its centre: integral of x² is 1/60 - 1/96, of x y 1/120 - 1/96.
  CHECK(before.second[0][0] == Approx(2.0 * (1.0 / 60 - 1.0 / 96)).epsilon(1e-14));
  CHECK(before.second[0][1] == Approx(1.0 / 96 - 1.0 / 120).epsilon(1e-14));
  const Pose pose{vec(3, -2, 5), brute::random_turn(random)};
  std::vector<Vec3> points;
  for (const Vec3 p : own) points.push_back(pose.to_world(p));
  const SolidMass after = solid_mass(make_hull(points));
  CHECK(after.volume == Approx(before.volume).epsilon(1e-14));
  CHECK(norm(after.centre - pose.to_world(before.centre)) < 1e-14);
  check_same(after.second, times_transposed(pose.R * before.second, pose.R), 1e-15);
}

TEST_CASE("mass: what does not move has none") { CHECK_THROWS_AS(solid_mass(HalfSpaceShape{}), Error); }
