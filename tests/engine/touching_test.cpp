// Who may touch, and what is told of it.
#include "contacts/touching.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "contacts/find.hpp"
#include "edit/edit.hpp"
#include "measure/measure.hpp"
#include "shapes/distance.hpp"
#include "snapshot/snapshot.hpp"
#include "step/step.hpp"

using namespace pantin;
using Catch::Contains;

namespace {

constexpr double gravity_here = 9.81;

ShapeDef solid(Geometry geometry, std::string layer = "") {
  ShapeDef def;
  def.geometry = std::move(geometry);
  def.layer = std::move(layer);
  return def;
}

ShapeId level_plane(World& world, std::string layer = "", bool sensor = false) {
  ShapeDef def = solid(HalfSpaceShape{}, std::move(layer));
  def.orientation = Quat{std::sqrt(0.5), -std::sqrt(0.5), 0, 0};
  def.sensor = sensor;
  return add_shape(world, def);
}

BodyId put_body(World& world, const ShapeDef& def, Vec3 at, Vec3 velocity = zero3()) {
  BodyDef body;
  body.shapes = {def};
  body.at = at;
  body.velocity = velocity;
  body.mass = 1.0;
  return add_body(world, body);
}

LayerRule rule_of(std::optional<double> friction, std::optional<double> restitution) {
  LayerRule rule;
  rule.friction = friction;
  rule.restitution = restitution;
  return rule;
}

LayerRule passing() {
  LayerRule rule;
  rule.collide = false;
  return rule;
}

const BoxShape cube = {vec(0.5, 0.5, 0.5)};

/// What was told in a step, as it is told to scripts in the next.
std::vector<Notice> told_in_step(World& world) {
  world.notices.clear();
  step(world);
  std::vector<Notice> told;
  for (const Notice& n : world.notices)
    if (n.kind == Notice::Kind::touched || n.kind == Notice::Kind::parted) told.push_back(n);
  return told;
}

std::size_t count_of(const std::vector<Notice>& list, Notice::Kind kind) {
  std::size_t count = 0;
  for (const Notice& n : list) count += n.kind == kind ? 1 : 0;
  return count;
}

/// Deepest overlap [m] of a door that swings towards the wall it hangs on, found without contacts.
double overlap_of_swinging_door(bool collide, double corner = 0.6, bool with_axis = true) {
  World world;
  world.settings.gravity = zero3();
  const auto with_point = [&](Vec3 at, Vec3 point, double mass) {
    BodyDef body;
    body.shapes = {solid(cube)};
    body.at = at;
    PointDef joint;
    joint.at = point;
    body.points = {joint};
    body.mass = mass;
    return add_body(world, body);
  };
  const BodyId wall = with_point(zero3(), vec(corner, corner, 0), 1000.0),
               door = with_point(vec(2 * corner, 2 * corner, 0), vec(-corner, -corner, 0), 1.0);
  HingeDef hinge;
  if (with_axis) hinge.axis = vec(0, 0, 1);
  hinge.collide = collide;
  add_hinge(world, std::vector<PointId>{world.bodies[wall].points[0], world.bodies[door].points[0]}, hinge);
  set_spin(world, door, vec(0, 0, -2));
  set_velocity(world, door, vec(2 * corner, -2 * corner, 0));
  double deepest = 0.0;
  for (int i = 0; i < 480; i++) {
    step(world);
    const auto pose = [&](BodyId body) { return pose_of(world, world.shapes[world.bodies[body].shapes[0]]); };
    deepest = std::max(deepest, -separation(cube, pose(wall), cube, pose(door)).distance);
  }
  return deepest;
}

}  // namespace

TEST_CASE("Bodies of a hinge pass through each other, unless it says that they collide") {
  CHECK(overlap_of_swinging_door(false) > 0.3);
  CHECK(overlap_of_swinging_door(true) < 1e-3);
  CHECK(overlap_of_swinging_door(true, 0.5) < 1e-3);
  CHECK(overlap_of_swinging_door(true, 0.5, false) < 1e-3);
}

TEST_CASE("Layers that do not collide pass, others are as before") {
  World world;
  level_plane(world, "floor");
  const BodyId ghost = put_body(world, solid(cube, "ghost"), vec(0, 0.5, 0)),
               car = put_body(world, solid(cube, "car"), vec(3, 0.5, 0)),
               plain = put_body(world, solid(cube), vec(6, 0.5, 0));
  set_rule(world, "ghost", "floor", passing());
  advance(world, 0.5);
  CHECK(world.motion_of(ghost).x[1] == Approx(0.5 - 0.5 * gravity_here * 0.25).margin(1e-9));
  CHECK(world.motion_of(car).x[1] == Approx(0.5).margin(1e-6));
  CHECK(world.motion_of(plain).x[1] == Approx(0.5).margin(1e-6));
  set_rule(world, "floor", "car", passing());
  const double before = world.motion_of(car).x[1];
  advance(world, 1.0);
  CHECK(world.motion_of(car).x[1] < before - 1.0);
  CHECK(world.motion_of(plain).x[1] == Approx(0.5).margin(1e-6));
}

TEST_CASE("A pair of layers has a friction of its own: a box slides v²/2µg") {
  World world;
  level_plane(world, "ice");
  set_rule(world, "rubber", "ice", rule_of(0.05, {}));
  const BodyId box = put_body(world, solid(cube, "rubber"), vec(0, 0.5, 0), vec(1, 0, 0));
  advance(world, 1.0 / (0.05 * gravity_here) + 0.5);
  CHECK(world.motion_of(box).x[0] == Approx(1.0 / (2 * 0.05 * gravity_here)).margin(1e-4));
}

TEST_CASE("A pair of layers has a restitution of its own: a ball has e² of its energy after a bounce") {
  World world;
  level_plane(world, "ice");
  set_rule(world, "ice", "rubber", rule_of({}, 0.6));
  const BodyId ball = put_body(world, solid(BallShape{0.5}, "rubber"), vec(0, 1.5, 0));
  double last = 0.0;
  for (int i = 0; i < 1000; i++) {
    step(world);
    const Motion& m = world.motion_of(ball);
    if (last < 0.0 && m.p[1] > 0.0) {
      CHECK(kinetic_energy(m) + gravity_here * (m.x[1] - 0.5) == Approx(0.36 * gravity_here).epsilon(1e-3));
      return;
    }
    last = m.p[1];
  }
  FAIL("it did not bounce");
}

TEST_CASE("The rule of a layer with itself, and one that is taken back") {
  World world;
  world.settings.gravity = zero3();
  const BodyId a = put_body(world, solid(cube, "swarm"), vec(-1, 0, 0), vec(1, 0, 0)),
               b = put_body(world, solid(cube, "swarm"), vec(1, 0, 0), vec(-1, 0, 0));
  set_rule(world, "swarm", "swarm", passing());
  advance(world, 0.25);
  const Snapshot snapshot = take_snapshot(world);
  advance(world, 2.0);
  CHECK(world.motion_of(a).x[0] == Approx(1.0).margin(1e-9));
  restore(world, snapshot);
  set_rule(world, "swarm", "swarm", {});
  advance(world, 2.0);
  CHECK(world.motion_of(a).x[0] == Approx(-0.5).margin(1e-5));
  CHECK(world.motion_of(b).x[0] == Approx(0.5).margin(1e-5));
  restore(world, snapshot);
  REQUIRE(world.layers.rules.size() == 1);
  CHECK_FALSE(world.layers.rules[0].collide);
}

TEST_CASE("Rules that cannot be are refused") {
  World world;
  const double nan = std::nan("");
  CHECK_THROWS_WITH(set_rule(world, "", "a", {}), Contains("a layer must have a name"));
  CHECK_THROWS_WITH(set_rule(world, "a", "b", rule_of(-1.0, {})), Contains("friction must be >= 0"));
  CHECK_THROWS_WITH(set_rule(world, "a", "b", rule_of(nan, {})), Contains("friction must be >= 0"));
  CHECK_THROWS_WITH(set_rule(world, "a", "b", rule_of({}, 1.5)), Contains("restitution must be from 0 to 1"));
  CHECK_THROWS_WITH(set_rule(world, "a", "b", rule_of({}, nan)), Contains("restitution must be from 0 to 1"));
  CHECK(world.layers.names.empty());
}

TEST_CASE("A sensor changes no bit of a motion, and tells when it is entered and left") {
  const bool plane = GENERATE(false, true);
  const auto fall = [&](bool with_sensor) {
    auto world = std::make_unique<World>();
    ShapeDef sensor = solid(BoxShape{vec(2, 0.5, 2)});
    sensor.sensor = true;
    if (with_sensor && plane) level_plane(*world, "", true);
    if (with_sensor && !plane) add_shape(*world, sensor);
    const BodyId ball = put_body(*world, solid(BallShape{0.25}), vec(0, 2.25, 0));
    watch(*world, world->contacts, true);
    return std::pair(std::move(world), ball);
  };
  const auto [world, ball] = fall(true);
  const auto [alone, same] = fall(false);
  const double top = plane ? 0.0 : 0.5, h = world->settings.step;
  const double entered = std::sqrt(2.0 * (2.0 - top) / gravity_here), left = std::sqrt(2.0 * 3.0 / gravity_here);
  std::vector<double> touched, parted;
  for (int i = 0; i < 240; i++) {
    for (const Notice& n : told_in_step(*world)) {
      (n.kind == Notice::Kind::touched ? touched : parted).push_back(world->time);
      if (n.kind != Notice::Kind::touched) continue;
      CHECK(n.touch.speed == Approx(gravity_here * entered).margin(gravity_here * h));
      CHECK(n.touch.impulse == 0.0);
      CHECK(norm(n.touch.normal - vec(0, 1, 0)) < 1e-12);
    }
    step(*alone);
    REQUIRE(world->motion_of(ball).x[1] == alone->motion_of(same).x[1]);
  }
  REQUIRE(touched.size() == 1);
  CHECK(touched[0] == Approx(entered + 0.5 * h).margin(0.5 * h + 1e-9));
  REQUIRE(parted.size() == (plane ? 0 : 1));
  if (!plane) CHECK(parted[0] == Approx(left + h).margin(h));
  CHECK(world->ledger.given[static_cast<std::size_t>(Source::contact)] == 0.0);
}

TEST_CASE("A sensor weighs nothing beside other shapes, alone as much as they do") {
  World world;
  ShapeDef range = solid(BallShape{3.0});
  range.sensor = true;
  BodyDef body;
  body.shapes = {solid(cube), range};
  CHECK(world.motion_of(add_body(world, body)).mass == Approx(1000.0));
  body.shapes = {range};
  CHECK(world.motion_of(add_body(world, body)).mass == Approx(1000.0 * 36.0 * M_PI));
}

TEST_CASE("A ball that strikes the floor tells speed, impulse and place") {
  const double restitution = GENERATE(0.0, 0.5);
  World world;
  const ShapeId floor = level_plane(world);
  set_restitution(world, floor, restitution);
  const BodyId ball = put_body(world, solid(BallShape{0.5}), vec(2, 1.5, 1));
  watch(world, world.contacts, true);
  const double speed = std::sqrt(2.0 * gravity_here), within = 2.0 * gravity_here * world.settings.step;
  std::vector<Notice> told;
  while (told.empty() && world.time < 1.0) told = told_in_step(world);
  REQUIRE(told.size() == 1);
  const Touch& touch = told[0].touch;
  CHECK(told[0].kind == Notice::Kind::touched);
  CHECK((touch.pair == TouchPair{ball, floor}));
  CHECK(world.time == Approx(std::sqrt(2.0 / gravity_here)).margin(2 * world.settings.step));
  CHECK(touch.speed == Approx(speed).margin(within));
  CHECK(touch.impulse == Approx((1.0 + restitution) * speed).margin(2 * within));
  CHECK(norm(touch.at - vec(2, 0, 1)) < 1e-6);
  CHECK(norm(touch.normal - vec(0, 1, 0)) < 1e-12);
  told.clear();
  const double until = world.time + 0.3;
  while (told.empty() && world.time < until) told = told_in_step(world);
  REQUIRE(told.size() == (restitution > 0.0 ? 1 : 0));
  if (restitution > 0.0) CHECK(told[0].kind == Notice::Kind::parted);
}

TEST_CASE("Boxes at rest touch once and do not part") {
  const double hz = GENERATE(60.0, 240.0);
  World world;
  world.settings.step = 1.0 / hz;
  level_plane(world);
  for (int i = 0; i < 5; i++) put_body(world, solid(cube), vec(0.05 * (i % 2), 0.5 + i, 0));
  watch(world, world.contacts, true);
  std::size_t touched = 0, parted = 0;
  for (int i = 0; i < 4 * static_cast<int>(hz); i++) {
    const std::vector<Notice> told = told_in_step(world);
    touched += count_of(told, Notice::Kind::touched);
    parted += count_of(told, Notice::Kind::parted);
  }
  CHECK(touched == 5);
  CHECK(parted == 0);
}

TEST_CASE("What is removed parts, with a handle that is dead") {
  World world;
  level_plane(world);
  const BodyId low = put_body(world, solid(cube), vec(0, 0.5, 0)), high = put_body(world, solid(cube), vec(0, 1.5, 0));
  watch(world, world.contacts, true);
  advance(world, 0.1);
  remove(world, high);
  const std::vector<Notice> told = told_in_step(world);
  REQUIRE(told.size() == 1);
  CHECK((told[0].touch.pair == TouchPair{low, high}));
  CHECK_FALSE(alive(world, told[0].touch.pair.b));
}

TEST_CASE("Who begins to watch is not told what touches already, and who ends is told nothing") {
  World world;
  level_plane(world);
  put_body(world, solid(cube), vec(0, 0.5, 0));
  advance(world, 0.1);
  watch(world, world.contacts, true);
  CHECK(told_in_step(world).empty());
  put_body(world, solid(cube), vec(3, 0.5, 0));
  CHECK(told_in_step(world).size() == 1);
  watch(world, world.contacts, false);
  put_body(world, solid(cube), vec(6, 0.5, 0));
  CHECK(told_in_step(world).empty());
  CHECK(world.contacts.touching.empty());
  CHECK(world.contacts.felt.empty());
}

TEST_CASE("A thousand balls that fall on a floor are told once each, in the same order each time") {
  const auto run = [] {
    World world;
    level_plane(world);
    for (int i = 0; i < 1000; i++) put_body(world, solid(BallShape{0.4}), vec(i % 40, 0.5 + 0.001 * (i % 7), i / 40));
    watch(world, world.contacts, true);
    std::vector<TouchPair> pairs;
    while (world.time < 0.3)
      for (const Notice& n : told_in_step(world)) {
        REQUIRE(n.kind == Notice::Kind::touched);
        pairs.push_back(n.touch.pair);
      }
    return pairs;
  };
  std::vector<TouchPair> first = run();
  CHECK(first == run());
  std::sort(first.begin(), first.end());
  CHECK(std::adjacent_find(first.begin(), first.end()) == first.end());
  CHECK(first.size() == 1000);
}

TEST_CASE("After a restore hinges keep their bodies from colliding, and touch is told as then") {
  World world;
  level_plane(world);
  BodyDef body;
  body.shapes = {solid(cube)};
  body.points.resize(1);
  body.at = vec(0, 2, 0);
  const BodyId a = add_body(world, body), b = add_body(world, body);
  const ParticleId hinge =
      add_hinge(world, std::vector<PointId>{world.bodies[a].points[0], world.bodies[b].points[0]}, {});
  watch(world, world.contacts, true);
  advance(world, 0.1);
  const Snapshot snapshot = take_snapshot(world);
  const auto go_on = [&] {
    std::vector<std::uint64_t> hashes;
    for (int i = 0; i < 200; i++) {
      hashes.push_back(told_in_step(world).size());
      hashes.push_back(state_hash(world));
    }
    return hashes;
  };
  const std::vector<std::uint64_t> first = go_on();
  CHECK(world.error.penetration < 1e-3);
  restore(world, snapshot);
  cut(world, hinge);
  step(world);
  restore(world, snapshot);
  CHECK(first == go_on());
}

TEST_CASE("The deepest overlap is an error of the scene") {
  World world;
  level_plane(world);
  const BodyId ball = put_body(world, solid(BallShape{0.5}), vec(0, 0.4, 0));
  CHECK(world.error.penetration == 0.0);
  step(world);
  CHECK(world.error.penetration == Approx(0.5 - world.motion_of(ball).x[1]).margin(1e-12));
  CHECK(world.error.penetration > 0.09);
  CHECK(accuracy(world).penetration == world.error.penetration);
  CHECK(world.worst.penetration == world.error.penetration);
  advance(world, 2.0);
  CHECK(world.error.penetration < 3e-4);
  CHECK(world.worst.penetration > 0.09);
}
