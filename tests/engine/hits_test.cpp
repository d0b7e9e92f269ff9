// Rays, casts, overlaps and positions in a world, against all of its shapes one by one.
#include "measure/hits.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "contacts/find.hpp"
#include "edit/edit.hpp"
#include "shapes/hull.hpp"
#include "shapes/mesh.hpp"
#include "shapes/ray.hpp"
#include "snapshot/snapshot.hpp"
#include "step/step.hpp"
#include "support/brute_shapes.hpp"

using namespace pantin;
using Catch::Contains;

namespace {

Geometry random_convex(Random& random) {
  const double a = 0.1 + 0.4 * random.uniform(), b = 0.1 + 0.4 * random.uniform();
  switch (static_cast<int>(5 * random.uniform())) {
    case 0: return BallShape{a};
    case 1: return BoxShape{vec(a, b, 0.2)};
    case 2: return CapsuleShape{a, b};
    case 3: return CylinderShape{a, b};
    default: return make_hull(brute::random_points(random, 12, a));
  }
}

Quat random_quat(Random& random) {
  const Vec3 v = brute::random_vector(random, 1.0);
  return normalised({random.uniform() - 0.5, v[0], v[1], v[2]});
}

/// Bodies and shapes of the world, all over the place.
void fill(World& world, Random& random, int bodies, int grounds) {
  for (int i = 0; i < bodies + grounds; i++) {
    ShapeDef shape;
    shape.geometry = random_convex(random);
    shape.at = brute::random_vector(random, 0.3);
    shape.orientation = random_quat(random);
    if (i % 3 == 0) shape.layer = "third";
    if (i < bodies) {
      BodyDef body;
      body.shapes = {shape};
      body.at = brute::random_vector(random, 5.0);
      body.orientation = random_quat(random);
      body.velocity = brute::random_vector(random, 2.0);
      add_body(world, body);
    } else {
      shape.at = brute::random_vector(random, 5.0);
      add_shape(world, shape);
    }
  }
  ShapeDef shape;
  shape.geometry = HalfSpaceShape{};
  shape.at = vec(0, 0, -4);
  add_shape(world, shape);
  shape.geometry = make_height_field(2, 2, 6.0, {0.0, 0.5, 1.0, 0.0});
  shape.at = vec(0, -4, 0);
  add_shape(world, shape);
}

/// (part or 0, shape), as they are expected, for all shapes for which `meet` gives a number.
template <class Meet>
std::vector<std::pair<double, ShapeId>> expected(const World& world, Meet meet) {
  std::vector<std::pair<double, ShapeId>> list;
  for (const ShapeId id : world.shapes.ids())
    if (const std::optional<double> number = meet(world.shapes[id].geometry, pose_of(world, world.shapes[id])))
      list.emplace_back(*number, id);
  std::stable_sort(list.begin(), list.end(), [](const auto& x, const auto& y) { return x.first < y.first; });
  return list;
}

void check_same(const std::vector<Hit>& hits, const std::vector<std::pair<double, ShapeId>>& wanted, double scale) {
  REQUIRE(hits.size() == wanted.size());
  for (std::size_t i = 0; i < hits.size(); i++) {
    CHECK(hits[i].distance == Approx(wanted[i].first * scale).margin(1e-12));
    if (i > 0) CHECK(hits[i].distance >= hits[i - 1].distance);
  }
  std::vector<ShapeId> of_hits, of_wanted;
  for (const Hit& hit : hits) of_hits.push_back(hit.shape);
  for (const auto& [number, id] : wanted) of_wanted.push_back(id);
  CHECK(of_hits == of_wanted);
}

/// Asks everything at random; returns how much was met.
std::size_t ask_all(World& world, Random& random, int questions) {
  std::size_t met = 0;
  for (int i = 0; i < questions; i++) {
    const Vec3 from = brute::random_vector(random, 6.0), to = brute::random_vector(random, 6.0), way = to - from;
    const auto by_ray = expected(world, [&](const Geometry& shape, const Pose& pose) -> std::optional<double> {
      const auto hit = ray(shape, pose, from, to);
      return hit ? std::optional<double>(hit->part) : std::nullopt;
    });
    const std::vector<Hit> hits = hits_of_ray(world, from, to);
    check_same(hits, by_ray, norm(way));
    met += hits.size();
    for (const Hit& hit : hits) {
      CHECK(norm(hit.at - from) == Approx(hit.distance).margin(1e-12));
      CHECK(norm(hit.normal) == Approx(1.0));
      CHECK(dot(hit.normal, way) <= 1e-12);
    }

    const Geometry moved = random_convex(random);
    const Pose pose{from, brute::random_turn(random)};
    const auto by_cast = expected(world, [&](const Geometry& shape, const Pose& at) -> std::optional<double> {
      const auto hit = cast(moved, pose, way, shape, at);
      return hit ? std::optional<double>(hit->part) : std::nullopt;
    });
    check_same(hits_of_cast(world, moved, pose, way), by_cast, norm(way));

    const auto by_overlap = expected(world, [&](const Geometry& shape, const Pose& at) -> std::optional<double> {
      return overlaps(moved, pose, shape, at) ? std::optional<double>(0.0) : std::nullopt;
    });
    std::vector<Hit> over = overlapping(world, moved, pose);
    REQUIRE(over.size() == by_overlap.size());
    met += over.size();
    for (const Hit& hit : over) {
      CHECK(std::any_of(by_overlap.begin(), by_overlap.end(), [&](const auto& w) { return w.second == hit.shape; }));
      const Shape& other = world.shapes[hit.shape];
      if (!is_convex(other.geometry)) continue;
      const Separation s = separation(moved, pose, other.geometry, pose_of(world, other));
      CHECK(hit.distance == Approx(s.distance).margin(1e-6));
    }

    const auto by_inside = expected(world, [&](const Geometry& shape, const Pose& at) -> std::optional<double> {
      return inside(shape, at, from) ? std::optional<double>(0.0) : std::nullopt;
    });
    check_same(containing(world, from), by_inside, 1.0);
    met += by_inside.size();
  }
  return met;
}

}  // namespace

TEST_CASE("What is met is what all shapes one by one give: before the first step, after steps, edits and a restore") {
  World world;
  Random random{7};
  world.settings.gravity = zero3();
  fill(world, random, 60, 60);
  CHECK(ask_all(world, random, 60) > 50);
  advance(world, 0.2);
  CHECK(ask_all(world, random, 60) > 50);
  for (const BodyId body : world.bodies.ids()) {
    set_position(world, body, brute::random_vector(random, 5.0));
    if (random.uniform() < 0.2) remove(world, body);
    const Vec3 from = brute::random_vector(random, 6.0), to = brute::random_vector(random, 6.0);
    const auto wanted = expected(world, [&](const Geometry& shape, const Pose& pose) -> std::optional<double> {
      const auto hit = ray(shape, pose, from, to);
      return hit ? std::optional<double>(hit->part) : std::nullopt;
    });
    check_same(hits_of_ray(world, from, to), wanted, norm(to - from));
  }
  fill(world, random, 20, 20);
  advance(world, 0.6);
  const Snapshot snapshot = take_snapshot(world);
  CHECK(ask_all(world, random, 60) > 50);
  advance(world, 1.2);
  restore(world, snapshot);
  CHECK(ask_all(world, random, 60) > 50);
}

TEST_CASE("Questions change no bit of a run") {
  const auto run = [](bool asks) {
    World world;
    Random random{11};
    fill(world, random, 40, 20);
    std::vector<Vec3> places;
    for (int i = 0; i < 100; i++) {
      if (asks) hits_of_ray(world, vec(-6, 0.1 * i, 0), vec(6, 0, 0));
      if (i == 50) set_position(world, world.bodies.ids()[3], vec(0, 5, 0));
      if (asks) overlapping(world, BallShape{1.0}, {});
      step(world);
      for (const BodyId body : world.bodies.ids()) places.push_back(world.motion_of(body).x);
    }
    return places;
  };
  const std::vector<Vec3> asked = run(true), silent = run(false);
  REQUIRE(asked.size() == silent.size());
  for (std::size_t i = 0; i < asked.size(); i++) REQUIRE(norm2(asked[i] - silent[i]) == 0.0);
}

TEST_CASE("An endless ray meets what is far, as far as closed forms say") {
  World world;
  ShapeDef ball;
  ball.geometry = BallShape{0.5};
  ball.at = vec(1e6, 0.3, 0);
  const ShapeId far = add_shape(world, ball);
  ball.at = vec(-3, 0, 0);
  add_shape(world, ball);
  ShapeDef plane;
  plane.geometry = HalfSpaceShape{};
  plane.at = vec(0, 0, -2);
  const ShapeId floor = add_shape(world, plane);
  const std::vector<Hit> hits = hits_of_endless_ray(world, zero3(), vec(17, 0, 0));
  REQUIRE(hits.size() == 1);
  CHECK(hits[0].shape == far);
  CHECK(hits[0].distance == Approx(1e6 - 0.4).margin(1e-9));
  CHECK(norm(hits[0].normal - vec(-0.8, -0.6, 0)) < 1e-6);
  for (const double size : {1e-300, 1e300})
    CHECK(hits_of_endless_ray(world, zero3(), vec(size, 0, 0))[0].distance == hits[0].distance);
  const std::vector<Hit> down = hits_of_endless_ray(world, vec(0, 0, 1), vec(1e-3, 0, -1));
  REQUIRE(down.size() == 1);
  CHECK(down[0].shape == floor);
  CHECK(down[0].distance == Approx(3.0 * std::sqrt(1.0 + 1e-6)).margin(1e-12));
  CHECK(hits_of_endless_ray(world, vec(0, 0, 1), vec(0, 0, 1)).empty());
  REQUIRE(hits_of_endless_ray(world, vec(0, 0, -3), vec(0, 0, 1)).size() == 1);
  CHECK(hits_of_endless_ray(world, vec(0, 0, -3), vec(0, 0, 1))[0].distance == 0.0);
}

TEST_CASE("A ray of no length meets what it begins in, and nonsense is refused") {
  World world;
  ShapeDef ball;
  const ShapeId only = add_shape(world, ball);
  const Vec3 nan = vec(std::nan(""), 0, 0), endless = vec(infinity, 0, 0);
  REQUIRE(hits_of_ray(world, zero3(), zero3()).size() == 1);
  CHECK(hits_of_ray(world, zero3(), zero3())[0].shape == only);
  CHECK(finite(hits_of_ray(world, zero3(), zero3())[0].normal));
  CHECK(hits_of_ray(world, vec(2, 0, 0), vec(2, 0, 0)).empty());
  CHECK_THROWS_WITH(hits_of_ray(world, nan, zero3()), Contains("ray: from must be finite"));
  CHECK_THROWS_WITH(hits_of_ray(world, zero3(), endless), Contains("ray: to must be finite"));
  CHECK_THROWS_WITH(hits_of_endless_ray(world, zero3(), zero3()), Contains("direction must have a length > 0"));
  CHECK_THROWS_WITH(hits_of_cast(world, HalfSpaceShape{}, {}, vec(1, 0, 0)), Contains("must be convex"));
  CHECK_THROWS_WITH(hits_of_cast(world, BallShape{1}, {}, nan), Contains("the way must be finite"));
  CHECK_THROWS_WITH(overlapping(world, HalfSpaceShape{}, {}), Contains("must be convex"));
  CHECK_THROWS_WITH(overlapping(world, BallShape{1}, {nan, identity33()}), Contains("at must be finite"));
  CHECK_THROWS_WITH(containing(world, nan), Contains("the position must be finite"));
  World empty;
  CHECK(hits_of_ray(empty, zero3(), vec(1, 0, 0)).empty());
}

TEST_CASE("Filters leave out layers, bodies and sensors") {
  World world;
  ShapeDef shape;
  shape.geometry = BallShape{0.1};
  const auto add = [&](double x, std::string layer, bool sensor) {
    shape.layer = std::move(layer);
    shape.sensor = sensor;
    BodyDef body;
    body.shapes = {shape};
    body.at = vec(x, 0, 0);
    return add_body(world, body);
  };
  const BodyId one = add(1, "red", false), two = add(2, "green", false);
  add(3, "", false);
  const BodyId sensor = add(4, "red", true);
  const auto met = [&](const HitFilter& filter) {
    std::vector<BodyId> bodies;
    for (const Hit& hit : hits_of_ray(world, zero3(), vec(9, 0, 0), filter))
      bodies.push_back(world.shapes[hit.shape].body);
    return bodies;
  };
  CHECK(met({}).size() == 3);
  HitFilter red;
  red.any_layer = false;
  red.layers = {layer_of(world, "red")};
  CHECK(met(red) == std::vector{one});
  red.sensors = true;
  CHECK(met(red) == std::vector{one, sensor});
  HitFilter but;
  but.ignored = {one, world.bodies[two].shapes[0]};
  CHECK(met(but).size() == 1);
}
