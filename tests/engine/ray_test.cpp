#include "shapes/ray.hpp"

#include <catch2/catch.hpp>

#include "shapes/distance.hpp"
#include "shapes/hull.hpp"
#include "shapes/mesh.hpp"
#include "support/brute_shapes.hpp"

using namespace pantin;

namespace {

using Face = std::array<std::uint32_t, 3>;

std::vector<Geometry> all_convex(Random& random) {
  return {BallShape{0.5}, BoxShape{vec(0.3, 0.5, 0.7)}, CapsuleShape{0.3, 0.6}, CylinderShape{0.5, 0.4},
          make_hull(brute::random_points(random, 12, 0.8))};
}

/// The surface of a box as twelve triangles.
std::shared_ptr<const TriangleMesh> box_mesh(Vec3 half) {
  std::vector<Vec3> corners;
  for (int i = 0; i < 8; i++) corners.push_back(half * vec(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
  const auto hull = make_hull(corners);
  std::vector<Face> faces;
  for (const Hull::Face& face : hull->faces)
    for (std::uint32_t i = 1; i + 1 < face.count; i++)
      faces.push_back({hull->loops[face.first], hull->loops[face.first + i], hull->loops[face.first + i + 1]});
  return make_mesh(hull->vertices, faces);
}

}  // namespace

TEST_CASE("ray: enters a convex shape where points on its way begin to be inside") {
  Random random;
  int hits = 0;
  for (const Geometry& shape : all_convex(random))
    for (int i = 0; i < 60; i++) {
      const Pose pose{brute::random_vector(random, 1.0), brute::random_turn(random)};
      const Vec3 from = pose.x + brute::random_direction(random) * 2.0, to = pose.x + brute::random_vector(random, 0.5);
      const auto hit = ray(shape, pose, from, to);
      const auto at = [&](double part) { return from + (to - from) * part; };
      const double first = hit ? hit->part : 1.0;
      for (int k = 0; k < 50; k++) CHECK_FALSE(inside(shape, pose, at((first - 1e-9) * k / 50.0)));
      if (!hit) continue;
      hits++;
      CHECK_FALSE(inside(shape, pose, at(first - 1e-12)));
      CHECK(inside(shape, pose, at(first + 1e-9)));
      CHECK(std::fabs(norm(hit->normal) - 1.0) < 1e-15);
      CHECK(dot(hit->normal, to - from) < 0.0);
      const Separation gap = separation(BallShape{1e-3}, {at(first) + hit->normal * 1e-3}, shape, pose);
      CHECK(std::fabs(gap.distance) < 1e-14);
    }
  CHECK(hits > 100);
}

TEST_CASE("ray: what is inside a convex shape is what has no positive distance from it") {
  Random random;
  for (const Geometry& shape : all_convex(random))
    for (int i = 0; i < 100; i++) {
      const Pose pose{brute::random_vector(random, 1.0), brute::random_turn(random)};
      const Vec3 point = pose.x + brute::random_vector(random, 1.0);
      CHECK(inside(shape, pose, point) == (separation(BallShape{1e-12}, {point}, shape, pose).distance < -1e-12));
    }
}

TEST_CASE("ray: that begins inside meets at once, against its direction; without a length it meets only there") {
  Random random;
  const Vec3 way = vec(3, 0, 4);
  std::vector<Geometry> shapes = all_convex(random);
  shapes.push_back(make_height_field(2, 2, 10.0, {1, 1, 1, 1}));
  for (const Geometry& shape : shapes) {
    const auto hit = ray(shape, {}, zero3(), way);
    REQUIRE(hit);
    CHECK(hit->part == 0.0);
    CHECK(norm(hit->normal + direction(way)) < 1e-15);
    CHECK(ray(shape, {}, zero3(), zero3()));
    CHECK_FALSE(ray(shape, {}, vec(0, 9, 0), vec(0, 9, 0)));
  }
}

TEST_CASE("ray: along faces and axes exactly, and off a surface, does as geometry says") {
  const BoxShape box{vec(1, 1, 1)};
  CHECK(ray(box, {}, vec(-3, 0, 0), vec(3, 0, 0))->part == 1.0 / 3.0);
  CHECK(ray(box, {}, vec(-3, 1, 0), vec(3, 1, 0))->part == 1.0 / 3.0);
  CHECK_FALSE(ray(box, {}, vec(-3, 1.0000001, 0), vec(3, 1.0000001, 0)));
  CHECK_FALSE(ray(box, {}, vec(1, 0, 0), vec(3, 0, 0)));
  CHECK(ray(CylinderShape{1, 2}, {}, vec(0, 0, 6), vec(0, 0, -2))->part == 0.5);
  CHECK(ray(CapsuleShape{1, 2}, {}, vec(0, 0, 7), vec(0, 0, -1))->part == 0.5);
  CHECK(ray(HalfSpaceShape{}, {}, vec(0, 0, 1), vec(5, 0, -3))->part == 0.25);
  CHECK(same(ray(HalfSpaceShape{}, {}, vec(0, 0, 1), vec(5, 0, -3))->normal, vec(0, 0, 1)));
  CHECK_FALSE(ray(HalfSpaceShape{}, {}, vec(0, 0, 1), vec(5, 0, 1)));
}

TEST_CASE("ray: a closed mesh is met where the convex shape with its faces is, from inside too") {
  Random random;
  const BoxShape box{vec(0.3, 0.5, 0.7)};
  const Geometry mesh = box_mesh(box.half);
  for (int i = 0; i < 200; i++) {
    const Pose pose{brute::random_vector(random, 1.0), brute::random_turn(random)};
    const Vec3 from = pose.x + brute::random_direction(random) * 2.0, to = pose.x + brute::random_vector(random, 1.0);
    const auto one = ray(box, pose, from, to), other = ray(mesh, pose, from, to);
    REQUIRE(one.has_value() == other.has_value());
    if (!one) continue;
    CHECK(std::fabs(one->part - other->part) < 1e-14);
    CHECK(norm(one->normal - other->normal) < 1e-14);
  }
  const auto out = ray(mesh, {}, zero3(), vec(1, 0, 0));
  REQUIRE(out);
  CHECK(out->part == Approx(0.3));
  CHECK(same(out->normal, vec(-1, 0, 0)));
}

TEST_CASE("ray: nothing gets through a mesh or a height field between triangles, along edges or through corners") {
  const Geometry mesh = box_mesh(vec(1, 1, 1)), field = make_height_field(5, 5, 0.5, std::vector<double>(25, 0.25));
  for (int i = 0; i <= 20; i++)
    for (int k = 0; k <= 20; k++) {
      const double x = -1.0 + 0.1 * i, z = -1.0 + 0.1 * k;
      CHECK(ray(field, {}, vec(x, 3, z), vec(x, -1, z)));
      CHECK(ray(mesh, {}, vec(3, 0.7 * x, 0.7 * z), vec(-3, 0.7 * x, 0.7 * z)));
      CHECK(ray(field, {}, vec(0.3, 2, 0.1), vec(x, -1, z))->part == Approx(1.75 / 3.0).epsilon(1e-14));
    }
}

TEST_CASE("cast: ends where shapes touch, and not before or after") {
  Random random;
  int hits = 0;
  const std::vector<Geometry> shapes = all_convex(random);
  for (const Geometry& a : shapes)
    for (const Geometry& b : shapes)
      for (int i = 0; i < 4; i++) {
        const Pose at_a{brute::random_direction(random) * 4.0, brute::random_turn(random)};
        const Pose at_b{zero3(), brute::random_turn(random)};
        const Vec3 way = (brute::random_vector(random, 0.7) - at_a.x) * 1.2;
        const auto gap = [&](double part) { return separation(a, {at_a.x + way * part, at_a.R}, b, at_b).distance; };
        const auto hit = cast(a, at_a, way, b, at_b);
        const double first = hit ? hit->part : 1.0;
        for (int k = 0; k < 10; k++) CHECK(gap(first * k / 10.0) > 0.0);
        if (!hit) continue;
        hits++;
        CHECK(std::fabs(gap(first)) < 1e-12);
        CHECK(dot(hit->normal, way) < 0.0);
      }
  CHECK(hits > 60);
}

TEST_CASE("cast: a ball of 1 cm meets a wall of 1 cm after 1000 m, at the right place to 1 nm") {
  const BallShape ball{0.005};
  const Vec3 way = vec(1000, 0, 0);
  const double wanted = 500.0 - 0.005 - 0.005;
  const Pose wall{vec(500, 0, 0)};
  std::vector<Geometry> walls{BoxShape{vec(0.005, 2, 2)}, box_mesh(vec(0.005, 2, 2))};
  for (const Geometry& shape : walls) {
    const auto hit = cast(ball, {}, way, shape, wall);
    REQUIRE(hit);
    CHECK(std::fabs(hit->part * 1000.0 - wanted) < 1e-9);
    CHECK(norm(hit->normal + vec(1, 0, 0)) < 1e-12);
    CHECK_FALSE(cast(ball, {vec(0, 2.0051, 0)}, way, shape, wall));
  }
}

TEST_CASE("cast: onto half spaces and height fields, and what overlaps them") {
  const BoxShape box{vec(1, 1, 1)};
  const auto on_plane = cast(box, {vec(0, 0, 3)}, vec(1, 0, -4), HalfSpaceShape{}, {});
  REQUIRE(on_plane);
  CHECK(on_plane->part == 0.5);
  CHECK_FALSE(cast(box, {vec(0, 0, 3)}, vec(1, 0, 4), HalfSpaceShape{}, {}));
  const Geometry field = make_height_field(3, 3, 2.0, {0, 0, 0, 0, 1, 0, 0, 0, 0});
  const auto on_top = cast(BallShape{0.5}, {vec(0, 5, 0)}, vec(0, -5, 0), field, {});
  REQUIRE(on_top);
  CHECK(on_top->part == Approx(0.7).epsilon(1e-12));
  CHECK(overlaps(BallShape{0.5}, {vec(0, 1.4, 0)}, field, {}));
  CHECK_FALSE(overlaps(BallShape{0.5}, {vec(0, 1.6, 0)}, field, {}));
  CHECK(overlaps(BallShape{0.1}, {vec(0, 0.5, 0)}, field, {}));
  CHECK(inside(field, {}, vec(0.1, -50, 0.2)));
  CHECK_FALSE(inside(field, {}, vec(2.1, -50, 0.2)));
}

TEST_CASE("cast: of shapes that overlap from the start has part 0, of those that part from a touch none") {
  const BoxShape box{vec(1, 1, 1)};
  const auto hit = cast(box, {vec(0, 0, 1.9)}, vec(0, 0, 5), box, {});
  REQUIRE(hit);
  CHECK(hit->part == 0.0);
  CHECK(same(hit->normal, vec(0, 0, 1)));
  CHECK_FALSE(cast(box, {vec(0, 0, 2)}, vec(0, 0, 5), box, {}));
  CHECK_FALSE(cast(box, {vec(0, 0, 2)}, vec(1, 0, 0), box, {}));
  CHECK(cast(box, {vec(0, 0, 2)}, vec(1, 0, -1), box, {})->part == 0.0);
}

TEST_CASE("cast: what overlaps is what has no positive distance") {
  Random random;
  const std::vector<Geometry> shapes = all_convex(random);
  for (const Geometry& a : shapes)
    for (const Geometry& b : shapes) {
      const Pose at_a{brute::random_vector(random, 0.8), brute::random_turn(random)};
      CHECK(overlaps(a, at_a, b, {}) == (separation(a, at_a, b, {}).distance <= 0.0));
    }
  const Geometry mesh = box_mesh(vec(1, 1, 1));
  CHECK(overlaps(BoxShape{vec(0.5, 0.5, 0.5)}, {vec(1.4, 0, 0)}, mesh, {}));
  CHECK_FALSE(overlaps(BoxShape{vec(0.5, 0.5, 0.5)}, {vec(1.6, 0, 0)}, mesh, {}));
  CHECK_FALSE(overlaps(BoxShape{vec(0.5, 0.5, 0.5)}, {}, mesh, {}));
}
