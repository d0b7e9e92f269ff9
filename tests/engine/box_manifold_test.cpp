// Where two boxes touch, against closed forms and distances found by trying everything.
#include <algorithm>
#include <catch2/catch.hpp>

#include "shapes/distance.hpp"
#include "support/touching.hpp"

using namespace pantin;

namespace {

using touching::points_of;

struct TwoBoxes {
  BoxShape a, b;
  Pose at_a, at_b;
  std::vector<ManifoldPoint> points(double margin) const { return points_of(a, at_a, b, at_b, margin); }
};

/// With surfaces less than 0.03 m apart or in each other.
TwoBoxes random_boxes(Random& random) {
  const auto half = [&] { return vec(0.2 + random.uniform(), 0.2 + random.uniform(), 0.2 + random.uniform()) * 0.5; };
  TwoBoxes two = {{half()}, {half()}, touching::random_pose(random, 0.1), touching::random_pose(random, 0.1)};
  const Vec3 away = brute::random_direction(random);
  double from = 0.0, to = 3.0;
  for (int i = 0; i < 30; i++) {
    two.at_a.x = away * (0.5 * (from + to));
    (separation(two.a, two.at_a, two.b, two.at_b).distance < 0.0 ? from : to) = 0.5 * (from + to);
  }
  two.at_a.x += away * (0.06 * (random.uniform() - 0.5));
  return two;
}

/// About y.
Mat3 yaw(double cosine, double sine) { return {{vec(cosine, 0, -sine), vec(0, 1, 0), vec(sine, 0, cosine)}}; }

}  // namespace

TEST_CASE("two boxes: one that rests on another touches at its four lower corners, with exact gaps") {
  const double gap = GENERATE(0.0, 0x1p-20, -0x1p-20);
  const TwoBoxes two = {{vec(0.5, 0.25, 0.5)}, {vec(1, 1, 1)}, {vec(0.125, 1.25 + gap, -0.25)}, {}};
  const auto points = two.points(0.02);
  REQUIRE(points.size() == 4);
  for (const ManifoldPoint& p : points) {
    CHECK(p.gap == gap);
    CHECK(same(p.normal, vec(0, 1, 0)));
    CHECK(p.on_a[1] == 1.0 + gap);
    CHECK(std::fabs(p.on_a[0] - 0.125) == 0.5);
    CHECK(std::fabs(p.on_a[2] + 0.25) == 0.5);
  }
  CHECK(touching::ids_of(points).size() == 4);
}

TEST_CASE("two boxes: turned by any angle about the upright, the gap is exact within 1e-15 of their size") {
  Random random;
  for (int i = 0; i < 100; i++) {
    const double t = random.uniform(), s = 1.0 / (1.0 + t * t);
    const Mat3 turn = yaw((1.0 - t * t) * s, 2.0 * t * s);
    const TwoBoxes two = {{vec(0.5, 0.5, 0.5)}, {vec(0.5, 0.5, 0.5)}, {vec(0.1, 1.0, 0), turn}, {}};
    const auto points = two.points(0.02);
    REQUIRE(points.size() == 4);
    for (const ManifoldPoint& p : points) CHECK(std::fabs(p.gap) <= 1e-15);
  }
}

TEST_CASE("two boxes: points of a symmetric scene are symmetric, those of a turned one regular") {
  const double c = std::sqrt(0.5);
  const TwoBoxes two = {{vec(0.5, 0.5, 0.5)}, {vec(0.5, 0.5, 0.5)}, {vec(0, 1, 0), yaw(c, c)}, {}};
  const auto points = two.points(0.02);
  REQUIRE(points.size() == 4);
  Vec3 sum = zero3();
  for (const ManifoldPoint& p : points) sum += p.on_a - vec(0, 0.5, 0);
  CHECK(norm(sum) <= 1e-15);
  for (const ManifoldPoint& p : points)
    CHECK(norm(p.on_a - vec(0, 0.5, 0)) == Approx(norm(points[0].on_a - vec(0, 0.5, 0))));
}

TEST_CASE("two boxes: every point lies on both surfaces, and the deepest is as deep as the boxes overlap") {
  Random random{.seed = 2};
  for (int i = 0; i < 1000; i++) {
    const TwoBoxes two = random_boxes(random);
    const auto points = two.points(0.05);
    const double distance = separation(two.a, two.at_a, two.b, two.at_b).distance;
    REQUIRE(!points.empty());
    // A face is taken for an edge pair that is hardly better.
    CHECK(touching::least_gap_of(points) <= distance + 1e-9);
    CHECK(touching::least_gap_of(points) >= distance - 2e-5 - 0.021 * std::fabs(distance));
    for (const ManifoldPoint& p : points) {
      CHECK(std::fabs(touching::outside_of(two.a, two.at_a, p.on_a)) <= 1e-12);
      CHECK(std::fabs(touching::outside_of(two.b, two.at_b, p.on_a - p.normal * p.gap)) <= 1e-12);
      CHECK(std::fabs(norm(p.normal) - 1.0) <= 1e-14);
    }
    CHECK(touching::ids_of(points).size() == points.size());
  }
}

TEST_CASE("two boxes: points keep their ids under motions by a billionth of their size") {
  Random random{.seed = 3};
  int kept = 0, pairs = 0;
  for (int i = 0; i < 300; i++, pairs++) {
    TwoBoxes two = random_boxes(random);
    const auto before = touching::ids_of(two.points(0.1));
    two.at_a = touching::nudged(two.at_a, random, 1e-9);
    kept += before == touching::ids_of(two.points(0.1)) ? 1 : 0;
  }
  CHECK(kept >= pairs - 1);
}

TEST_CASE("two boxes: a stack that trembles by round-off keeps its points and its reference face") {
  Random random{.seed = 4};
  TwoBoxes two = {{vec(0.5, 0.5, 0.5)}, {vec(0.5, 0.5, 0.5)}, {vec(0, 1, 0)}, {}};
  const auto ids = touching::ids_of(two.points(0.02));
  REQUIRE(ids.size() == 4);
  const Pose still = two.at_a;
  for (int i = 0; i < 200; i++) {
    two.at_a = touching::nudged(still, random, 1e-10);
    CHECK(touching::ids_of(two.points(0.02)) == ids);
  }
}

TEST_CASE("two boxes: a scene made smaller by a power of two is the same scene, bit for bit") {
  Random random{.seed = 5};
  const double scale = GENERATE(0x1p-20, 0x1p-10, 0x1p+10);
  for (int i = 0; i < 100; i++) {
    TwoBoxes two = random_boxes(random);
    const auto points = two.points(0.05);
    two = {
        {two.a.half * scale}, {two.b.half * scale}, {two.at_a.x * scale, two.at_a.R}, {two.at_b.x * scale, two.at_b.R}};
    const auto scaled = two.points(0.05 * scale);
    REQUIRE(scaled.size() == points.size());
    for (std::size_t k = 0; k < points.size(); k++) {
      CHECK(scaled[k].id == points[k].id);
      CHECK(scaled[k].gap == Approx(points[k].gap * scale).margin(1e-14 * scale));
    }
  }
}

TEST_CASE("two boxes: crossed edges touch at one point and keep what the best face may meet within the step") {
  const double c = std::sqrt(0.5), tilt = 0.02;
  // The lower one shows an edge along z, the upper one an edge that is nearly along x.
  const Mat3 edge_up{{vec(c, c, 0), vec(-c, c, 0), vec(0, 0, 1)}};
  const Mat3 edge_down{{vec(1, 0, 0), vec(0, c, c), vec(0, -c, c)}};
  const BoxShape cube{vec(0.5, 0.5, 0.5)};
  const auto crossed =
      points_of(cube, {vec(0, 2 * std::sqrt(0.5) - 1e-3, 0), edge_down}, cube, {zero3(), edge_up}, 0.02);
  REQUIRE(!crossed.empty());
  CHECK(crossed[0].gap == Approx(-1e-3).epsilon(1e-9));
  CHECK(norm(crossed[0].normal - vec(0, 1, 0)) <= 1e-14);
  for (std::size_t i = 1; i < crossed.size(); i++) CHECK(crossed[i].gap >= 0.0);

  const Mat3 leaning = matrix(normalised({1, tilt, 0, tilt}));
  const auto lying = points_of(cube, {vec(0.9, 1.02, 0.9), leaning}, cube, {}, 0.1);
  CHECK(lying.size() >= 2);
}

TEST_CASE("two boxes: those nearest at two corners have that pair of points") {
  const BoxShape cube{vec(0.5, 0.5, 0.5)};
  const auto points = points_of(cube, {vec(1.01, 1.02, 1.02), identity33()}, cube, {}, 0.05);
  REQUIRE(points.size() == 1);
  CHECK(points[0].gap == Approx(0.03).epsilon(1e-12));
  CHECK(norm(points[0].on_a - vec(0.51, 0.52, 0.52)) <= 1e-14);
  CHECK(points_of(cube, {vec(1.01, 1.02, 1.02), identity33()}, cube, {}, 0.025).empty());
}
