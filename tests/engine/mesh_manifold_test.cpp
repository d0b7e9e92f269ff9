// Where convex shapes touch triangles: no edge is felt that does not stick out.
#include <algorithm>
#include <catch2/catch.hpp>

#include "shapes/mesh.hpp"
#include "support/touching.hpp"

using namespace pantin;

namespace {

using touching::points_of;

/// n x n squares of 0.3 m about the origin, of two triangles each.
template <class Height>
std::shared_ptr<const TriangleMesh> ground_mesh(std::uint32_t n, Height height) {
  std::vector<Vec3> vertices;
  std::vector<std::array<std::uint32_t, 3>> faces;
  for (std::uint32_t j = 0; j <= n; j++)
    for (std::uint32_t i = 0; i <= n; i++) {
      const double x = 0.3 * (i - 0.5 * n), z = 0.3 * (j - 0.5 * n);
      vertices.push_back(vec(x, height(x, z), z));
    }
  for (std::uint32_t j = 0; j < n; j++)
    for (std::uint32_t i = 0; i < n; i++) {
      const std::uint32_t a = j * (n + 1) + i, b = a + 1, c = a + n + 1, d = c + 1;
      faces.push_back({a, c, b});
      faces.push_back({b, c, d});
    }
  return make_mesh(vertices, faces);
}

double level_ground(double, double) { return 0.0; }
double rolling_ground(double x, double z) { return 0.1 * (x * x - 1.5 * z * z) * (1.0 - 0.3 * x * z); }

std::vector<Geometry> falling_shapes() {
  Random random{.seed = 21};
  return {BallShape{0.5}, BoxShape{vec(0.5, 0.4, 0.3)}, CapsuleShape{0.2, 0.4}, CylinderShape{0.4, 0.3},
          make_hull(brute::random_points(random, 20, 0.6))};
}

/// Outer surface of a box.
std::shared_ptr<const TriangleMesh> box_mesh(Vec3 half) {
  std::vector<Vec3> corners;
  for (int i = 0; i < 8; i++)
    corners.push_back(half * vec((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1));
  const std::vector<std::array<std::uint32_t, 3>> faces = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6},
                                                           {0, 1, 4}, {1, 5, 4}, {2, 6, 3}, {3, 6, 7},
                                                           {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return make_mesh(corners, faces);
}

}  // namespace

TEST_CASE("mesh: what slides over level triangles feels only their normal, and its exact gap") {
  const Geometry ground = ground_mesh(12, level_ground);
  Random random{.seed = 22};
  for (const Geometry& shape : falling_shapes())
    for (int i = 0; i < 60; i++) {
      Pose pose = {zero3(), brute::random_turn(random)};
      if (i % 3 == 0) pose.R = identity33();
      const double gap = i % 2 == 0 ? -1e-6 * i : 0.02 * (random.uniform() - 0.7);
      pose.x = vec(0.01 * i, gap - bounds_of(shape, pose).low[1], i % 4 == 0 ? 0.0 : 0.3 * random.uniform());
      const auto points = points_of(shape, pose, ground, {}, 0.03);
      CAPTURE(shape.index(), i);
      REQUIRE(!points.empty());
      for (const ManifoldPoint& p : points) {
        CHECK(norm(p.normal - vec(0, 1, 0)) <= 1e-15);
        CHECK(std::fabs(touching::outside_of(shape, pose, p.on_a)) <= 1e-10);
      }
      CHECK(touching::least_gap_of(points) == Approx(gap).margin(1e-14));
    }
}

TEST_CASE("mesh: a point on an edge or a corner that triangles share is told once") {
  const Geometry ground = ground_mesh(12, level_ground);
  for (const double x : {0.0, 0.15, 0.3})
    CHECK(points_of(BallShape{0.2}, {vec(x, 0.2, 0)}, ground, {}, 0.01).size() == 1);
  const auto points = points_of(BoxShape{vec(0.45, 0.1, 0.45)}, {vec(0, 0.1, 0)}, ground, {}, 0.01);
  for (std::size_t i = 0; i < points.size(); i++)
    for (std::size_t k = 0; k < i; k++) CHECK(norm(points[i].on_a - points[k].on_a) > 1e-6);
}

TEST_CASE("mesh: a height field is the same ground as a mesh of its triangles") {
  const Geometry field = make_height_field(13, 13, 0.3, std::vector<double>(169, 0.0));
  for (const Geometry& shape : falling_shapes()) {
    Pose pose = {vec(0.11, 0, 0.07), identity33()};
    pose.x[1] = -bounds_of(shape, pose).low[1] - 1e-4;
    const auto points = points_of(shape, pose, field, {}, 0.01);
    REQUIRE(!points.empty());
    for (const ManifoldPoint& p : points) CHECK(norm(p.normal - vec(0, 1, 0)) <= 1e-15);
    CHECK(touching::least_gap_of(points) == Approx(-1e-4).margin(1e-14));
  }
}

TEST_CASE("mesh: nothing is lost on its way into rolling ground") {
  const Geometry ground = ground_mesh(12, rolling_ground);
  Random random{.seed = 23};
  for (const Geometry& shape : falling_shapes())
    for (int i = 0; i < 12; i++) {
      const double z = random.uniform() - 0.5, x = random.uniform() - 0.5;
      Pose pose = {vec(x, 1.0, z), brute::random_turn(random)};
      double last = infinity;
      CAPTURE(shape.index(), i);
      for (; pose.x[1] > 0.15; pose.x[1] -= 0.025) {
        const double gap = touching::least_gap_of(points_of(shape, pose, ground, {}, 0.03));
        CHECK(!(gap > last && last < 0.0));
        CHECK((last == infinity || gap > last - 0.06));
        last = gap;
      }
      CHECK(last < 0.0);
    }
}

TEST_CASE("mesh: a ball over a ridge is pushed along the line from it, over a corner too") {
  const Geometry mesh = box_mesh(vec(1, 1, 1));
  const double r = 0.3, c = std::sqrt(0.5);
  const auto ridge = points_of(BallShape{r}, {vec(1 + c * r, 1 + c * r, 0.2)}, mesh, {}, 0.01);
  REQUIRE(ridge.size() == 1);
  CHECK(norm(ridge[0].normal - vec(c, c, 0)) <= 1e-12);
  CHECK(std::fabs(ridge[0].gap) <= 1e-14);
  const double d = r / std::sqrt(3.0);
  const auto corner = points_of(BallShape{r}, {vec(1 + d, 1 + d, 1 + d)}, mesh, {}, 0.01);
  REQUIRE(corner.size() == 1);
  CHECK(norm(corner[0].normal - direction(vec(1, 1, 1))) <= 1e-12);
}

TEST_CASE("mesh: a box that hangs over the rim of another, or stands close to its side, is not pushed sideways") {
  const Geometry mesh = box_mesh(vec(1, 1, 1));
  const BoxShape box{vec(0.3, 0.3, 0.3)};
  for (const double depth : {-1e-3, 1e-7, 1e-5, 1e-3}) {
    const auto over = points_of(box, {vec(1.1, 1.3 - depth, 0.05)}, mesh, {}, 0.01);
    REQUIRE(over.size() >= 4);
    for (const ManifoldPoint& p : over) {
      CHECK(norm(p.normal - vec(0, 1, 0)) <= 1e-12);
      CHECK(p.gap == Approx(-depth).margin(1e-12));
    }
    const auto beside = points_of(box, {vec(1.3 - depth, 0.8, 0.05)}, mesh, {}, 0.01);
    REQUIRE(!beside.empty());
    for (const ManifoldPoint& p : beside) CHECK(norm(p.normal - vec(1, 0, 0)) <= 1e-12);
  }
}

TEST_CASE("mesh: a box on a mesh of a box has the points it has on the box, at any turn") {
  Random random{.seed = 24};
  for (int i = 0; i < 20; i++) {
    const Pose at_b = touching::random_pose(random, 5.0);
    const Pose at_a = at_b * Pose{vec(0.2, 1.3 - 1e-4, 0.3), identity33()};
    const auto points = points_of(BoxShape{vec(0.3, 0.3, 0.3)}, at_a, box_mesh(vec(1, 1, 1)), at_b, 0.01);
    REQUIRE(points.size() >= 4);
    for (const ManifoldPoint& p : points) {
      CHECK(p.gap == Approx(-1e-4).margin(1e-13));
      CHECK(norm(p.normal - at_b.R[1]) <= 1e-12);
    }
  }
}

TEST_CASE("mesh: what has sunk into a front by less than its thickness goes back, what is behind is not felt") {
  const Geometry ground = ground_mesh(12, level_ground);
  const BoxShape plate{vec(0.4, 0.1, 0.4)};
  const auto sunk = points_of(plate, {vec(0.02, -0.05, 0.03)}, ground, {}, 0.01);
  REQUIRE(!sunk.empty());
  for (const ManifoldPoint& p : sunk) {
    CHECK(norm(p.normal - vec(0, 1, 0)) <= 1e-15);
    CHECK(p.gap == Approx(-0.15).margin(1e-14));
  }
  CHECK(points_of(plate, {vec(0.02, -0.11, 0.03)}, ground, {}, 0.05).empty());
}

TEST_CASE("mesh: ids stay under motions by a billionth of the size") {
  const Geometry ground = ground_mesh(12, rolling_ground);
  Random random{.seed = 25};
  int kept = 0, trials = 0;
  for (const Geometry& shape : falling_shapes())
    for (int i = 0; i < 10; i++, trials++) {
      const Pose pose = {vec(random.uniform(), 0.45, random.uniform()), brute::random_turn(random)};
      const auto before = touching::ids_of(points_of(shape, pose, ground, {}, 0.05));
      const auto after = touching::ids_of(points_of(shape, touching::nudged(pose, random, 1e-9), ground, {}, 0.05));
      kept += before == after ? 1 : 0;
    }
  CHECK(kept >= trials - 2);
}
