// Where shapes touch: convex ones with each other and with half spaces.
#include <catch2/catch.hpp>

#include "shapes/distance.hpp"
#include "support/touching.hpp"

using namespace pantin;

namespace {

using touching::points_of;

std::vector<Geometry> convex_shapes(double scale = 1.0) {
  Random random{.seed = 11};
  return {BallShape{0.5 * scale}, BoxShape{vec(0.5, 0.4, 0.3) * scale}, CapsuleShape{0.2 * scale, 0.4 * scale},
          CylinderShape{0.4 * scale, 0.3 * scale}, make_hull(brute::random_points(random, 20, 0.6 * scale))};
}

std::shared_ptr<const Hull> hull_of_box(Vec3 half) {
  std::vector<Vec3> corners;
  for (const double x : {-half[0], half[0]})
    for (const double y : {-half[1], half[1]})
      for (const double z : {-half[2], half[2]}) corners.push_back(vec(x, y, z));
  return make_hull(corners);
}

/// A half space below y = 0.
Pose ground() { return {zero3(), {{vec(1, 0, 0), vec(0, 0, -1), vec(0, 1, 0)}}}; }

/// Moves a out of b or into it until they are 0.03 scale deep to 0.03 scale apart.
void bring_together(const Geometry& a, Pose& at_a, const Geometry& b, const Pose& at_b, Random& random, double scale) {
  const Vec3 away = brute::random_direction(random);
  double from = 0.0, to = 3.0 * scale;
  for (int i = 0; i < 20; i++) {
    at_a.x = at_b.x + away * (0.5 * (from + to));
    (separation(a, at_a, b, at_b).distance < 0.0 ? from : to) = 0.5 * (from + to);
  }
  at_a.x += away * (0.06 * scale * (random.uniform() - 0.5));
}

/// The turn that takes y to z: cylinders and capsules stand upright.
Mat3 upright() { return {{vec(1, 0, 0), vec(0, 0, -1), vec(0, 1, 0)}}; }

Mat3 tilted(double angle, double about_x, double about_z) {
  return matrix(normalised({1.0, 0.5 * angle * about_x, 0.0, 0.5 * angle * about_z})) * upright();
}

}  // namespace

TEST_CASE("manifolds: of each two convex shapes every point lies on both surfaces, the nearest ones among them") {
  const double scale = GENERATE(1.0, 1e-6, 1e3);
  const std::vector<Geometry> shapes = convex_shapes(scale);
  Random random{.seed = 12};
  for (const Geometry& a : shapes)
    for (const Geometry& b : shapes)
      for (int i = 0; i < 12; i++) {
        if (std::holds_alternative<BoxShape>(a) && std::holds_alternative<BoxShape>(b)) continue;
        Pose at_a = touching::random_pose(random, 0.0);
        const Pose at_b = touching::random_pose(random, scale);
        bring_together(a, at_a, b, at_b, random, scale);
        const auto points = points_of(a, at_a, b, at_b, 0.05 * scale);
        const double distance = separation(a, at_a, b, at_b).distance;
        CAPTURE(a.index(), b.index(), i, scale);
        REQUIRE(!points.empty());
        bool has_nearest = false;
        for (const ManifoldPoint& p : points) {
          // Nearest points of cylinders are found by search.
          CHECK(std::fabs(touching::outside_of(a, at_a, p.on_a)) <= 1e-6 * scale);
          CHECK(std::fabs(touching::outside_of(b, at_b, p.on_a - p.normal * p.gap)) <= 1e-6 * scale);
          CHECK(std::fabs(norm(p.normal) - 1.0) <= 1e-14);
          has_nearest = has_nearest || std::fabs(p.gap - distance) <= 2e-6 * scale;
        }
        CHECK(has_nearest);
        CHECK(touching::ids_of(points).size() == points.size());
      }
}

TEST_CASE("manifolds: points of shapes with flat faces lie on both surfaces within 1e-12") {
  const std::vector<Geometry> shapes = convex_shapes();
  Random random{.seed = 13};
  for (const std::size_t i : {1u, 2u, 4u})
    for (const std::size_t j : {1u, 2u, 4u})
      for (int trial = 0; trial < 30; trial++) {
        Pose at_a = touching::random_pose(random, 0.0);
        bring_together(shapes[i], at_a, shapes[j], {}, random, 1.0);
        for (const ManifoldPoint& p : points_of(shapes[i], at_a, shapes[j], {}, 0.05)) {
          CHECK(std::fabs(touching::outside_of(shapes[i], at_a, p.on_a)) <= 1e-12);
          CHECK(std::fabs(touching::outside_of(shapes[j], {}, p.on_a - p.normal * p.gap)) <= 1e-12);
        }
      }
}

TEST_CASE("manifolds: a hull with the corners of a box has the points of the box") {
  const Vec3 half = vec(0.5, 0.25, 0.375);
  const Pose at_a = {vec(0.125, 1.25 - 1e-4, 0.25), identity33()};
  const BoxShape box{half}, table{vec(1, 1, 1)};
  const auto expected = points_of(box, at_a, table, {}, 0.02);
  for (const auto& points : {points_of(hull_of_box(half), at_a, table, {}, 0.02),
                             points_of(hull_of_box(half), at_a, hull_of_box(table.half), {}, 0.02)}) {
    REQUIRE(points.size() == 4);
    for (const ManifoldPoint& p : points) {
      CHECK(p.gap == Approx(-1e-4).epsilon(1e-10));
      CHECK(norm(p.normal - vec(0, 1, 0)) <= 1e-14);
      CHECK(std::any_of(expected.begin(), expected.end(),
                        [&](const ManifoldPoint& q) { return norm(p.on_a - q.on_a) <= 1e-14; }));
    }
  }
}

TEST_CASE("manifolds: capsules and cylinders that lie on a box touch it along a line") {
  const BoxShape table{vec(1, 1, 1)};
  for (const Geometry& round : {Geometry(CapsuleShape{0.25, 0.5}), Geometry(CylinderShape{0.25, 0.5})}) {
    const auto points =
        points_of(round, {vec(0.75, 1.25, 0), {{vec(0, 0, -1), vec(0, 1, 0), vec(1, 0, 0)}}}, table, {}, 0.02);
    REQUIRE(points.size() == 2);
    CHECK(std::fmax(points[0].on_a[0], points[1].on_a[0]) == 1.0);  // the table ends there
    CHECK(std::fmin(points[0].on_a[0], points[1].on_a[0]) == 0.25);
    for (const ManifoldPoint& p : points) CHECK(std::fabs(p.gap) <= 1e-15);
  }
}

TEST_CASE("manifolds: two parallel capsules, or cylinders, touch at both ends of what they have side by side") {
  for (const Geometry& round : {Geometry(CapsuleShape{0.25, 0.5}), Geometry(CylinderShape{0.25, 0.5})}) {
    const auto points = points_of(round, {vec(0, 0.5 + 1e-3, 0.25)}, round, {}, 0.02);
    REQUIRE(points.size() == 2);
    CHECK(std::fabs(points[0].on_a[2] - points[1].on_a[2]) == Approx(0.75));
    for (const ManifoldPoint& p : points) {
      CHECK(p.gap == Approx(1e-3).epsilon(1e-9));
      CHECK(norm(p.normal - vec(0, 1, 0)) <= 1e-12);
    }
  }
}

TEST_CASE("manifolds: a capsule along an edge of a box touches at two points") {
  const double c = std::sqrt(0.5);
  const BoxShape box{vec(0.5, 0.5, 0.5)};
  const Pose edge_up = {zero3(), {{vec(c, c, 0), vec(-c, c, 0), vec(0, 0, 1)}}};
  const auto points = points_of(CapsuleShape{0.2, 0.3}, {vec(0, c + 0.2, 0)}, box, edge_up, 0.02);
  REQUIRE(points.size() >= 2);
  int on_edge = 0;
  for (const ManifoldPoint& p : points)
    on_edge += std::fabs(std::fabs(p.on_a[2]) - 0.3) <= 1e-12 && std::fabs(p.gap) <= 1e-12 ? 1 : 0;
  CHECK(on_edge == 2);
}

TEST_CASE("manifolds: a cylinder on a cylinder touches all round the smaller cap") {
  const auto points = points_of(CylinderShape{0.3, 0.2}, {vec(0.125, 0, 0.7)}, CylinderShape{0.5, 0.5}, {}, 0.02);
  REQUIRE(points.size() == 4);
  Vec3 sum = zero3();
  for (const ManifoldPoint& p : points) {
    CHECK(std::fabs(p.gap) <= 1e-15);
    CHECK(norm(p.on_a - vec(0.125, 0, 0.5)) == Approx(0.3).epsilon(1e-14));
    sum += p.on_a - vec(0.125, 0, 0.5);
  }
  CHECK(norm(sum) <= 1e-14);
}

TEST_CASE(
    "manifolds: of a small box on a large cap all four corners touch, of a large cap beyond a box the box's corners") {
  const BoxShape box{vec(0.3, 0.3, 0.3)};
  for (const double radius : {0.45, 2.0}) {
    const auto points = points_of(box, {vec(0, 0, 0.5)}, CylinderShape{radius, 0.2}, {}, 0.02);
    REQUIRE(points.size() == 4);
    for (const ManifoldPoint& p : points) CHECK(norm(p.on_a - vec(0, 0, 0.2)) == Approx(0.3 * std::sqrt(2.0)));
  }
}

TEST_CASE("half space: the lowest point is exact, at any turn of any convex shape") {
  Random random{.seed = 14};
  for (const Geometry& shape : convex_shapes())
    for (int i = 0; i < 50; i++) {
      Pose pose = {vec(3, 0, -2), brute::random_turn(random)};
      pose.x[1] = 0.01 - bounds_of(shape, pose).low[1];
      const auto points = points_of(shape, pose, HalfSpaceShape{}, ground(), 0.02);
      REQUIRE(!points.empty());
      CHECK(points.size() <= 4);
      CHECK(touching::least_gap_of(points) == Approx(0.01).margin(1e-14));
      for (const ManifoldPoint& p : points) {
        CHECK(std::fabs(touching::outside_of(shape, pose, p.on_a)) <= 1e-14);
        CHECK(std::fabs(p.on_a[1] - p.gap) <= 1e-14);
        CHECK(same(p.normal, vec(0, 1, 0)));
      }
    }
}

TEST_CASE("half space: a box has its four lowest corners, however far the margin reaches") {
  const BoxShape slab{vec(1, 0.01, 1)};
  const auto points = points_of(slab, {vec(0, 0.01, 0)}, HalfSpaceShape{}, ground(), 0.5);
  REQUIRE(points.size() == 4);
  for (const ManifoldPoint& p : points) CHECK(p.gap == 0.0);
}

TEST_CASE("half space: a standing cylinder has four points that tell its lowest, and do not jump while it trembles") {
  const CylinderShape cylinder{0.4, 0.5};
  Random random{.seed = 15};
  const auto still = points_of(cylinder, {vec(0, 0.5, 0), upright()}, HalfSpaceShape{}, ground(), 0.02);
  REQUIRE(still.size() == 4);
  for (int i = 0; i < 50; i++) {
    const double x = random.uniform() - 0.5, z = random.uniform() - 0.5;
    const auto trembling = points_of(cylinder, {vec(0, 0.5, 0), tilted(1e-10, x, z)}, HalfSpaceShape{}, ground(), 0.02);
    REQUIRE(trembling.size() == 4);
    for (std::size_t k = 0; k < 4; k++) CHECK(norm(trembling[k].on_a - still[k].on_a) <= 1e-9);

    const Pose leaning = {vec(0, 0.5, 0), tilted(0.01, x, z)};
    const auto points = points_of(cylinder, leaning, HalfSpaceShape{}, ground(), 0.02);
    CHECK(touching::least_gap_of(points) == Approx(bounds_of(cylinder, leaning).low[1]).margin(1e-15));
    CHECK(touching::ids_of(points) == touching::ids_of(still));
  }
}

TEST_CASE("half space: a lying cylinder or capsule has both ends of its line") {
  for (const Geometry& round : {Geometry(CapsuleShape{0.25, 0.5}), Geometry(CylinderShape{0.25, 0.5})}) {
    const auto points = points_of(round, {vec(0, 0.25, 0)}, HalfSpaceShape{}, ground(), 0.02);
    REQUIRE(points.size() == 2);
    for (const ManifoldPoint& p : points) {
      CHECK(p.gap == 0.0);
      CHECK(std::fabs(p.on_a[2]) == 0.5);
    }
  }
}

TEST_CASE("manifolds: ids stay while the same features meet") {
  const std::vector<Geometry> shapes = convex_shapes();
  Random random{.seed = 16};
  int kept = 0, pairs = 0;
  for (const Geometry& a : shapes)
    for (const Geometry& b : shapes)
      for (int i = 0; i < 8; i++, pairs++) {
        Pose at_a = touching::random_pose(random, 0.0);
        bring_together(a, at_a, b, {}, random, 1.0);
        const auto before = touching::ids_of(points_of(a, at_a, b, {}, 0.2));
        const auto after = touching::ids_of(points_of(a, touching::nudged(at_a, random, 1e-9), b, {}, 0.2));
        kept += before == after ? 1 : 0;
      }
  CHECK(kept >= pairs - 2);
}
