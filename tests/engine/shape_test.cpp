#include "shapes/shape.hpp"

#include <catch2/catch.hpp>

#include "base/check.hpp"
#include "shapes/hull.hpp"
#include "shapes/mesh.hpp"
#include "support/brute_shapes.hpp"

using namespace pantin;

namespace {

std::vector<Geometry> all_convex(Random& random) {
  return {BallShape{0.3}, BoxShape{vec(0.2, 0.5, 0.9)}, CapsuleShape{0.2, 0.6}, CylinderShape{0.4, 0.3},
          make_hull(brute::random_points(random, 12, 0.8))};
}

}  // namespace

TEST_CASE("shape: bounds of a turned convex shape touch it on all six sides") {
  Random random;
  for (const Geometry& shape : all_convex(random))
    for (int i = 0; i < 20; i++) {
      const Pose pose{brute::random_vector(random, 2.0), brute::random_turn(random)};
      const Bounds bounds = bounds_of(shape, pose);
      for (int k = 0; k < 3; k++) {
        Vec3 axis = zero3();
        axis[k] = 1.0;
        const auto along = [&](Vec3 d) {
          return pose.to_world(support_of_core(shape, transposed_times(pose.R, d))) + d * rounding_of(shape);
        };
        CHECK(std::fabs(along(axis)[k] - bounds.high[k]) < 2e-15);
        CHECK(std::fabs(along(-axis)[k] - bounds.low[k]) < 2e-15);
      }
    }
}

TEST_CASE("shape: no point of a core is farther along a direction than its support") {
  Random random;
  for (const Geometry& shape : all_convex(random))
    for (int i = 0; i < 50; i++) {
      const Vec3 d = brute::random_direction(random), best = support_of_core(shape, d);
      CHECK(norm(best) <= reach_of(shape) * (1.0 + 1e-15));
      for (int k = 0; k < 20; k++)
        CHECK(dot(support_of_core(shape, brute::random_direction(random)), d) <= dot(best, d) + 1e-15);
    }
}

TEST_CASE("shape: a support along no direction, or along an axis exactly, is a point of the shape") {
  Random random;
  for (const Geometry& shape : all_convex(random))
    for (const Vec3 d : {zero3(), vec(0, 0, 1), vec(0, 0, -1), vec(1, 0, 0), vec(1e-200, 0, 0)}) {
      const Vec3 at = support_of_core(shape, d);
      CHECK(finite(at));
      CHECK(norm(at) <= reach_of(shape));
    }
}

TEST_CASE("shape: its thickness is its smallest extent, its reach its largest distance from the origin") {
  CHECK(thickness_of(BallShape{0.3}) == 0.6);
  CHECK(thickness_of(BoxShape{vec(0.2, 0.5, 0.9)}) == 0.4);
  CHECK(thickness_of(CapsuleShape{0.2, 0.6}) == 0.4);
  CHECK(thickness_of(CylinderShape{0.4, 0.3}) == 0.6);
  CHECK(reach_of(BoxShape{vec(2, 3, 6)}) == 7.0);
  CHECK(reach_of(CapsuleShape{0.25, 0.5}) == 0.75);
  CHECK(reach_of(CylinderShape{3, 4}) == 5.0);
  CHECK(reach_of(HalfSpaceShape{}) == infinity);
  CHECK(thickness_of(HalfSpaceShape{}) == infinity);
}

TEST_CASE("shape: what does not move is not convex") {
  CHECK(is_convex(BallShape{1}));
  CHECK_FALSE(is_convex(HalfSpaceShape{}));
  CHECK_FALSE(is_convex(make_height_field(2, 2, 1.0, {0, 0, 0, 0})));
}

TEST_CASE("shape: lengths that are not 1e-12 m to 1e12 m, and shapes that are missing, are refused") {
  CHECK_NOTHROW(check_shape(BallShape{1e-12}));
  CHECK_THROWS_WITH(check_shape(BallShape{0.0}), Catch::Contains("radius is 0 m"));
  CHECK_THROWS_AS(check_shape(BallShape{std::nan("")}), Error);
  CHECK_THROWS_AS(check_shape(BoxShape{vec(1, -1, 1)}), Error);
  CHECK_THROWS_AS(check_shape(CapsuleShape{1, infinity}), Error);
  CHECK_THROWS_AS(check_shape(CylinderShape{-0.0, 1}), Error);
  CHECK_THROWS_WITH(check_shape(std::shared_ptr<const Hull>{}), Catch::Contains("missing"));
}
