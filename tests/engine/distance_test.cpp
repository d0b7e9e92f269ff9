#include "shapes/distance.hpp"

#include <catch2/catch.hpp>

#include "shapes/hull.hpp"
#include "support/allocations.hpp"
#include "support/brute_shapes.hpp"

using namespace pantin;

namespace {

struct Shape {
  Geometry shape;
  brute::Convex brute;
};

enum Kind { ball, capsule, box, hull };

Shape random_shape(Random& random, int kind, double size) {
  const auto length = [&] { return size * (0.2 + 0.8 * random.uniform()); };
  const double radius = length(), half = length(), other = length();
  if (kind == ball) return {BallShape{radius}, brute::convex(std::vector<Vec3>{zero3()}, radius)};
  if (kind == capsule)
    return {CapsuleShape{radius, half}, brute::convex(std::vector<Vec3>{vec(0, 0, -half), vec(0, 0, half)}, radius)};
  if (kind == box) return {BoxShape{vec(radius, half, other)}, brute::convex(BoxShape{vec(radius, half, other)})};
  const std::vector<Vec3> points = brute::random_points(random, 8, size);
  return {make_hull(points), brute::convex(points)};
}

void check_pair(const Shape& a, const Pose& at_a, const Shape& b, const Pose& at_b, double size) {
  const Separation found = separation(a.shape, at_a, b.shape, at_b);
  const brute::Convex put_a = brute::put(a.brute, at_a, at_a.x), put_b = brute::put(b.brute, at_b, at_a.x);
  CHECK(std::fabs(brute::distance(put_a, put_b) - found.distance) < 1e-14 * size);
  CHECK(std::fabs(norm(found.normal) - 1.0) < 1e-15);
  if (std::fabs(found.distance) > 1e-6 * size)
    CHECK(std::fabs(brute::gap_along(put_a, put_b, found.normal) - found.distance) < 1e-14 * size);
  const double rounding = 1e-14 * size + 4e-16 * (largest(at_a.x) + largest(at_b.x));
  CHECK(norm(found.on_a - found.on_b - found.normal * found.distance) < rounding);
  const Geometry point = BallShape{1e-12};
  CHECK(separation(point, {found.on_a}, a.shape, at_a).distance < rounding);
  CHECK(separation(point, {found.on_b}, b.shape, at_b).distance < rounding);
}

/// All pairs of kinds, put by place(random, size).
template <class Place>
void check_pairs(int times, double size_a, double size_b, Place place) {
  Random random;
  for (int i = 0; i < times; i++)
    for (int one = ball; one <= hull; one++)
      for (int other = ball; other <= hull; other++) {
        const Shape a = random_shape(random, one, size_a), b = random_shape(random, other, size_b);
        const auto [at_a, at_b] = place(random, size_a + size_b);
        check_pair(a, at_a, b, at_b, size_a + size_b);
      }
}

std::pair<Pose, Pose> anywhere(Random& random, double size) {
  const Pose a{brute::random_vector(random, size), brute::random_turn(random)};
  const Vec3 aside = brute::random_direction(random);
  return {a, {a.x + aside * (1.5 * size * random.uniform()), brute::random_turn(random)}};
}

}  // namespace

TEST_CASE("distance: of balls, capsules, boxes and hulls anywhere is what trying every feature gives") {
  check_pairs(8, 1.0, 1.0, anywhere);
}

TEST_CASE("distance: of 1 μm beside 1 km, and of thousandths, is exact to their size") {
  check_pairs(2, 1e-6, 1e3, anywhere);
  check_pairs(2, 1e3, 1e-6, anywhere);
  check_pairs(2, 1.0, 1e-3, anywhere);
}

TEST_CASE("distance: 1000 km from the origin is as exact as the poses are") {
  check_pairs(2, 1.0, 1.0, [](Random& random, double size) {
    auto [a, b] = anywhere(random, size);
    const Vec3 far = vec(1e6, -1e6, 1e6);
    return std::pair<Pose, Pose>{{a.x + far, a.R}, {b.x + far, b.R}};
  });
}

TEST_CASE("distance: of shapes with the same axes, at the same place, or turned by 1e-8 rad is exact") {
  check_pairs(2, 1.0, 1.0, [](Random& random, double size) {
    const auto [a, b] = anywhere(random, size);
    return std::pair<Pose, Pose>{a, {b.x, a.R}};
  });
  check_pairs(2, 1.0, 1.0, [](Random&, double) { return std::pair<Pose, Pose>{}; });
  check_pairs(2, 1.0, 1.0, [](Random& random, double) {
    const Quat q{1.0, 1e-8 * random.uniform(), 1e-8 * random.uniform(), 1e-8 * random.uniform()};
    return std::pair<Pose, Pose>{{}, {vec(0, 1.5 * random.uniform(), 0), matrix(normalised(q))}};
  });
}

TEST_CASE("distance: of shapes moved to nearly touch, by gaps and overlaps down to round-off, is exact") {
  Random random;
  for (int i = 0; i < 64; i++) {
    const Shape a = random_shape(random, i % 4, 1.0), b = random_shape(random, i / 4 % 4, 1.0);
    auto [at_a, at_b] = anywhere(random, 2.0);
    const Separation before = separation(a.shape, at_a, b.shape, at_b);
    const double gap = std::pow(0.1, 2 + i / 4) * (i % 2 == 0 ? 1.0 : -1.0);
    at_b.x += before.normal * (before.distance - gap);
    check_pair(a, at_a, b, at_b, 2.0);
  }
}

TEST_CASE("distance: a shape on top of the same is apart by exactly 0, not by less") {
  std::vector<Vec3> corners;
  for (int i = 0; i < 8; i++) corners.push_back(vec(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
  const BoxShape cube{vec(1, 1, 1)};
  const std::vector<Geometry> flat{cube, make_hull(corners), CylinderShape{1, 1}};
  for (const Geometry& a : flat)
    for (const Geometry& b : flat) {
      const Separation found = separation(a, {vec(0, 0, 2)}, b, {});
      CHECK(found.distance == 0.0);
      CHECK_FALSE(std::signbit(found.distance));
      CHECK(same(found.normal, vec(0, 0, 1)));
      CHECK(std::fabs(found.on_a[2] - 1.0) < 1e-15);
    }
  for (const Geometry& round : {Geometry(BallShape{1}), Geometry(CapsuleShape{1, 3})}) {
    const Separation found = separation(round, {vec(2, 0, 0)}, round, {});
    CHECK(found.distance == 0.0);
    CHECK(same(found.normal, vec(1, 0, 0)));
  }
}

TEST_CASE("distance: of a cylinder to a point is a closed form, seen from its side, its cap and its rim") {
  const CylinderShape cylinder{2, 1};
  const auto to_ball = [&](Vec3 at) { return separation(BallShape{0.5}, {at}, cylinder, {}).distance; };
  CHECK(to_ball(vec(5, 0, 0.5)) == 2.5);
  CHECK(to_ball(vec(0.5, 0.5, 4)) == 2.5);
  CHECK(to_ball(vec(5, 0, 5)) == 4.5);
  CHECK(to_ball(vec(0, 1.5, 0)) == -1.0);
  CHECK(to_ball(vec(0, 0, 0)) == -1.5);
}

TEST_CASE("distance: no direction within 1e-3 to 1e-9 parts a cylinder from another shape better") {
  Random random;
  const std::vector<Geometry> others{CylinderShape{0.7, 0.4}, BoxShape{vec(0.5, 0.3, 0.8)}, CapsuleShape{0.2, 0.6},
                                     make_hull(brute::random_points(random, 10, 0.8))};
  for (int i = 0; i < 40; i++) {
    const Geometry cylinder = CylinderShape{0.4, 0.6}, &other = others[static_cast<std::size_t>(i) % 4];
    const auto [at_a, at_b] = anywhere(random, 0.8);
    const auto gap_along = [&, a = at_a, b = at_b](Vec3 n) {
      const Vec3 on_a = a.R * support_of_core(cylinder, transposed_times(a.R, -n));
      const Vec3 on_b = b.R * support_of_core(other, transposed_times(b.R, n));
      return dot(n, a.x - b.x + on_a - on_b) - rounding_of(other);
    };
    const Separation found = separation(cylinder, at_a, other, at_b);
    CHECK(std::fabs(gap_along(found.normal) - found.distance) < 4e-15);
    CHECK(norm(found.on_a - found.on_b - found.normal * found.distance) < 4e-15);
    for (const double aside : {1e-3, 1e-5, 1e-7, 1e-9})
      for (int k = 0; k < 8; k++) {
        const Vec3 n = direction(found.normal + brute::random_direction(random) * aside);
        CHECK(gap_along(n) < found.distance + 4e-15);
      }
    const Geometry point = BallShape{1e-12};
    CHECK(separation(point, {found.on_a}, cylinder, at_a).distance < 1e-12);
    CHECK(separation(point, {found.on_b}, other, at_b).distance < 1e-12);
  }
}

TEST_CASE("distance: what the last search found changes nothing but round-off, nor does the order of two shapes") {
  Random random;
  for (int i = 0; i < 64; i++) {
    const Shape a = random_shape(random, i % 4, 1.0), b = random_shape(random, i / 4 % 4, 1.0);
    const auto [at_a, at_b] = anywhere(random, 2.0);
    const double distance = separation(a.shape, at_a, b.shape, at_b).distance;
    SeparationCache cache{brute::random_direction(random)};
    for (int k = 0; k < 2; k++)
      CHECK(std::fabs(separation(a.shape, at_a, b.shape, at_b, infinity, &cache).distance - distance) < 1e-14);
    CHECK(std::fabs(separation(b.shape, at_b, a.shape, at_a).distance - distance) < 1e-14);
  }
}

TEST_CASE("distance: past what is asked for, it is only known to be more") {
  Random random;
  for (int i = 0; i < 64; i++) {
    const Shape a = random_shape(random, i % 4, 1.0), b = random_shape(random, i / 4 % 4, 1.0);
    const auto [at_a, at_b] = anywhere(random, 4.0);
    const double distance = separation(a.shape, at_a, b.shape, at_b).distance;
    const double beyond = separation(a.shape, at_a, b.shape, at_b, 0.1).distance;
    if (distance > 0.1)
      CHECK((beyond > 0.1 && beyond < distance + 1e-14));
    else
      CHECK(std::fabs(beyond - distance) < 1e-14);
  }
}

TEST_CASE("distance: takes no memory from the heap") {
  Random random;
  const auto hull = make_hull(brute::random_points(random, 30, 1.0));
  const std::vector<Geometry> shapes{BallShape{0.5}, BoxShape{vec(0.5, 0.6, 0.7)}, CylinderShape{0.5, 0.5}, hull,
                                     CapsuleShape{0.3, 0.5}};
  separation(shapes[1], {}, CapsuleShape{0.3, 0.5}, {});
  std::uint64_t taken = 0;
  for (int i = 0; i < 200; i++)
    for (const Geometry& a : shapes)
      for (const Geometry& b : shapes) {
        const auto [at_a, at_b] = anywhere(random, 1.0);
        const std::uint64_t before = allocations();
        separation(a, at_a, b, at_b);
        taken += allocations() - before;
      }
  CHECK(taken == 0);
}
