#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "articulates/articulate.hpp"
#include "contacts/find.hpp"
#include "edit/assemble.hpp"
#include "edit/constrain.hpp"
#include "edit/coupling_constraints.hpp"
#include "edit/edit.hpp"
#include "measure/measure.hpp"
#include "snapshot/snapshot.hpp"
#include "step/step.hpp"

using namespace pantin;

namespace {

constexpr double g = 9.81;

ShapeDef shape(Geometry geometry, double friction = 0.5, double restitution = 0.0) {
  ShapeDef def;
  def.geometry = std::move(geometry);
  def.material.friction = friction;
  def.material.restitution = restitution;
  return def;
}

PointDef point(Vec3 at) {
  PointDef def;
  def.at = at;
  return def;
}

const BoxShape unit_box = {vec(0.5, 0.5, 0.5)};

/// A floor at height 0, inclined about z by an angle [rad], downhill along +x.
ShapeId add_floor(World& world, double friction = 0.5, double restitution = 0.0, double slope = 0.0) {
  ShapeDef def = shape(HalfSpaceShape{}, friction, restitution);
  const double up = -M_PI / 4;
  def.orientation = Quat{std::cos(slope / 2), 0, 0, -std::sin(slope / 2)} * Quat{std::cos(up), std::sin(up), 0, 0};
  return add_shape(world, def);
}

BodyId add(World& world, const ShapeDef& def, Vec3 at, Vec3 velocity = zero3(), double mass = 1.0) {
  BodyDef body;
  body.shapes = {def};
  body.at = at;
  body.velocity = velocity;
  body.mass = mass;
  return add_body(world, body);
}

double total(const World& world) {
  const Energy e = energy(world);
  return e.kinetic + e.potential;
}

double less_push_out(const World& world) {
  return total(world) - world.ledger.given[static_cast<std::size_t>(Source::push_out)];
}

double deepest(const World& world) {
  double depth = 0.0;
  for (const Contact& c : world.contacts.list) depth = std::fmax(depth, -c.gap);
  return depth;
}

void set_rate(World& world, double hz) { world.settings.step = 1.0 / hz; }

}  // namespace

TEST_CASE("A ball that loses nothing rises as high as it fell, for twenty bounces") {
  const double hz = GENERATE(60.0, 240.0);
  World world;
  set_rate(world, hz);
  add_floor(world, 0.5, 1.0);
  const BodyId ball = add(world, shape(BallShape{0.5}, 0.5, 1.0), vec(0, 2, 0));
  const double start = total(world);
  int bounces = 0;
  double last = 0.0;
  while (bounces < 20) {
    step(world);
    const double v = world.motion_of(ball).p[1];
    if (last < 0.0 && v > 0.0) bounces++;
    last = v;
  }
  CHECK(std::fabs(total(world) - start) < 20 * 1e-8 * start);
}

TEST_CASE("A ball of restitution 0.8 has 0.64 of its energy after each bounce") {
  World world;
  add_floor(world, 0.5, 0.8);
  const BodyId ball = add(world, shape(BallShape{0.5}, 0.5, 0.8), vec(0, 2, 0));
  double expected = 1.5 * g, last = 0.0;
  for (int bounces = 0; bounces < 5;) {
    step(world);
    const Motion& m = world.motion_of(ball);
    if (last < 0.0 && m.p[1] > 0.0) {
      bounces++;
      expected *= 0.64;
      CHECK(std::fabs(kinetic_energy(m) + g * (m.x[1] - 0.5) - expected) < 1e-3 * expected);
    }
    last = m.p[1];
  }
}

TEST_CASE("A box slides v²/2µg far") {
  const double speed = GENERATE(1.0, 5.0, 20.0);
  World world;
  add_floor(world);
  const BodyId box = add(world, shape(unit_box), vec(0, 0.5, 0), vec(speed, 0, 0));
  advance(world, speed / (0.5 * g) + 0.5);
  const Vec3 x = world.motion_of(box).x;
  CHECK(std::fabs(x[0] - speed * speed / g) < 1e-4);
  CHECK(std::fabs(x[2]) < 1e-6);
  CHECK(norm(world.motion_of(box).p) < 1e-7);
}

TEST_CASE("A sliding ball ends up rolling at 5/7 of its speed") {
  World world;
  add_floor(world);
  const BodyId ball = add(world, shape(BallShape{0.5}), vec(0, 0.5, 0), vec(5, 0, 0));
  advance(world, 2.0);
  CHECK(std::fabs(world.motion_of(ball).p[0] - 5.0 * 5 / 7) < 1e-6);
}

TEST_CASE("A slope holds below the angle of friction, and lets slide above it as fast as it should") {
  const double part = GENERATE(0.99, 1.01);
  const double slope = std::atan(0.5 * part);
  World world;
  add_floor(world, 0.5, 0.0, slope);
  const Vec3 up = vec(std::sin(slope), std::cos(slope), 0), along = vec(std::cos(slope), -std::sin(slope), 0);
  const BodyId box = add(world, shape(unit_box), up * 0.5);
  set_orientation(world, box, {std::cos(slope / 2), 0, 0, -std::sin(slope / 2)});
  constexpr double time = 4.0;
  advance(world, time);
  const double slid = dot(world.motion_of(box).x - up * 0.5, along);
  const double acceleration = g * (std::sin(slope) - 0.5 * std::cos(slope));
  if (part < 1.0)
    CHECK(std::fabs(slid) < 1e-6);
  else
    CHECK(std::fabs(slid - 0.5 * acceleration * time * time) < 1e-3 * slid);
}

TEST_CASE("Stacks stand where they were built") {
  const double hz = GENERATE(60.0, 240.0);
  const int boxes = GENERATE(10, 30);
  World world;
  set_rate(world, hz);
  add_floor(world);
  std::vector<BodyId> stack;
  for (int i = 0; i < boxes; i++) stack.push_back(add(world, shape(unit_box), vec(0, 0.5 + i, 0)));
  advance(world, 3.0);
  double creep = 0.0;
  for (int i = 0; i < boxes; i++)
    creep = std::fmax(creep, norm(world.motion_of(stack[static_cast<std::size_t>(i)]).x - vec(0, 0.5 + i, 0)));
  CHECK(creep < 1e-6);
  CHECK(deepest(world) < 1e-6);
}

TEST_CASE("A stack of five carries a box a thousand times and a hundred thousand times its own mass") {
  const double ratio = GENERATE(1e3, 1e5);
  World world;
  add_floor(world);
  for (int i = 0; i < 4; i++) add(world, shape(unit_box), vec(0, 0.5 + i, 0));
  const BodyId top = add(world, shape(unit_box), vec(0, 4.5, 0), zero3(), ratio);
  advance(world, 2.0);
  CHECK(norm(world.motion_of(top).x - vec(0, 4.5, 0)) < 1e-4);
}

TEST_CASE("Things fall by no shape's name through the floor, however fast") {
  const Geometry falling = GENERATE(Geometry(BallShape{0.005}), Geometry(BoxShape{vec(0.005, 0.005, 0.005)}),
                                    Geometry(CapsuleShape{0.005, 0.01}));
  World world;
  ShapeDef wall = shape(BoxShape{vec(5, 0.005, 5)});
  add_shape(world, wall);
  const BodyId body = add(world, shape(falling), vec(0, 3, 0), vec(0, -1000, 0));
  advance(world, 0.2);
  CHECK(world.motion_of(body).x[1] > 0.0);
}

namespace {

/// A chain of links with box shapes along x, the first perhaps nailed.
std::vector<BodyId> add_links(World& world, int links, double height, bool nailed) {
  std::vector<BodyId> bodies;
  for (int i = 0; i < links; i++) {
    BodyDef def;
    def.shapes = {shape(BoxShape{vec(0.4, 0.1, 0.1)})};
    def.points = {point(vec(-0.5, 0, 0)), point(vec(0.5, 0, 0))};
    def.at = vec(i, height, 0);
    def.mass = 1.0;
    bodies.push_back(add_body(world, def));
    const PointId head = world.bodies[bodies.back()].points[0];
    if (i > 0) {
      const PointId both[] = {world.bodies[bodies[bodies.size() - 2]].points[1], head};
      add_hinge(world, both);
    } else if (nailed) {
      add_nail(world, head);
    }
  }
  return bodies;
}

}  // namespace

TEST_CASE("A chain that falls on the floor keeps its hinges closed, and gains no energy") {
  World world;
  add_floor(world);
  add_links(world, 20, 3.0, false);
  add(world, shape(unit_box), vec(4, 0.5, 0));
  keep_ledger(world);
  double last = total(world), rise = 0.0;
  const double start = last;
  while (world.time < 3.0) {
    step(world);
    rise = std::fmax(rise, less_push_out(world) - last);
    last = less_push_out(world);
  }
  CHECK(world.worst.hinge_gap < 1e-11);
  CHECK(rise < 1e-5 * start);
  CHECK(world.stats.fallback_steps == 0);
  CHECK(deepest(world) < 1e-3);
}

TEST_CASE("A chain hits what stands beside it, and its energy is told") {
  World world;
  add_floor(world);
  add_links(world, 5, 6.0, true);
  for (int i = 0; i < 3; i++) add(world, shape(unit_box), vec(0.0, 0.5 + i, 0));
  keep_ledger(world);
  advance(world, 3.0);
  CHECK(world.worst.hinge_gap < 1e-11);
  CHECK(world.ledger.given[static_cast<std::size_t>(Source::contact)] < 0.0);
  CHECK(world.error.energy < 1e-3);
}

namespace {

void add_pile(World& world, int count) {
  add_floor(world);
  Random random{7};
  for (int i = 0; i < count; i++) {
    const Vec3 at = vec(2 * random.uniform() - 1, 1.0 + 1.2 * i, 2 * random.uniform() - 1);
    const BodyId body = add(world, i % 2 == 0 ? shape(unit_box) : shape(BallShape{0.5}), at);
    set_orientation(world, body, normalised({1, random.uniform(), random.uniform(), random.uniform()}));
  }
}

}  // namespace

TEST_CASE("A pile falls, loses energy only, and nothing goes through the floor") {
  const double hz = GENERATE(60.0, 240.0);
  World world;
  set_rate(world, hz);
  add_pile(world, 16);
  keep_ledger(world);
  const double start = total(world);
  double last = start, rise = 0.0;
  while (world.time < 4.0) {
    step(world);
    rise = std::fmax(rise, less_push_out(world) - last);
    last = less_push_out(world);
  }
  CHECK(rise < 1e-5 * start);
  CHECK(world.stats.unsolved_islands < world.steps);
  for (BodyId id : world.bodies.ids()) CHECK(world.motion_of(id).x[1] > 0.4);
}

TEST_CASE("What contacts give though they may only take is told as an error of the energy") {
  World world;
  set_rate(world, 60);
  add_pile(world, 16);
  const auto pushed_out = [&] { return world.ledger.given[static_cast<std::size_t>(Source::push_out)]; };
  double last = total(world), pushed = 0.0, gained = 0.0;
  const double start = last;
  while (world.time < 4.0) {
    step(world);
    gained += std::fmax(0.0, total(world) - last - (pushed_out() - pushed));
    last = total(world);
    pushed = pushed_out();
  }
  CHECK(gained > 1e-9 * start);
  CHECK(gained <= world.worst_energy + 1e-9 * start);
}

TEST_CASE("A snapshot in a pile that falls goes on with the same bits") {
  World world;
  add_pile(world, 10);
  advance(world, 1.5);
  const Snapshot kept = take_snapshot(world);
  advance(world, 2.0);
  const std::uint64_t hash = state_hash(world);
  restore(world, kept);
  advance(world, 2.0);
  CHECK(state_hash(world) == hash);
}

TEST_CASE("A belt carries what lies on it at its speed") {
  World world;
  ShapeDef belt = shape(BoxShape{vec(50, 0.5, 5)});
  belt.material.surface_velocity = vec(2, 0, 0);
  add_shape(world, belt);
  const BodyId box = add(world, shape(unit_box), vec(0, 1, 0));
  advance(world, 2.0);
  CHECK(std::fabs(world.motion_of(box).p[0] - 2.0) < 1e-6);
}

TEST_CASE("A hand that presses a box on the floor does not press it through") {
  World world;
  add_floor(world);
  BodyDef def;
  def.shapes = {shape(unit_box)};
  def.points = {point(vec(0.3, 0.5, 0))};
  def.at = vec(0, 0.5, 0);
  def.mass = 1.0;
  const BodyId box = add_body(world, def);
  FollowDef hand;
  hand.at = vec(0.3, -3, 0);
  hand.max_force = 500.0;
  add_follow(world, world.bodies[box].points[0], hand);
  advance(world, 2.0);
  CHECK(world.motion_of(box).x[1] > 0.499);
  CHECK(norm(world.motion_of(box).p) < 1e-3);
}

TEST_CASE("A ball that rolls drives what is geared to it, and the gear stays exact") {
  World world;
  add_floor(world);
  const BodyId ball = add(world, shape(BallShape{0.5}), vec(0, 0.5, 0));
  BodyDef def;
  def.points = {point(zero3())};
  def.inertia = identity33() * 0.1;
  def.mass = 1.0;
  def.at = vec(0, 3, 0);
  const BodyId wheel = add_body(world, def);
  add_nail(world, world.bodies[wheel].points[0]);
  GearDef gear;
  gear.axis_a = vec(0, 0, 1);
  gear.ratio.value = -0.5;
  add_gear(world, ball, wheel, gear);
  set_spin(world, ball, vec(0, 0, -2));
  set_spin(world, wheel, vec(0, 0, 4));
  advance(world, 0.5);
  const double a = angular_velocity(world.motion_of(ball))[2], b = angular_velocity(world.motion_of(wheel))[2];
  CHECK(b > 0.5);
  CHECK(std::fabs(a / b + 0.5) < 1e-9);
  CHECK(std::fabs(world.motion_of(ball).p[0] + 0.5 * a) < 1e-6);
}

TEST_CASE("Bodies that share a hinge do not collide; others do") {
  World world;
  BodyDef def;
  def.shapes = {shape(unit_box)};
  def.points = {point(vec(0.25, 0, 0))};
  const BodyId a = add_body(world, def);
  def.at = vec(0.5, 0, 0);
  def.points = {point(vec(-0.25, 0, 0))};
  const BodyId b = add_body(world, def);
  const PointId both[] = {world.bodies[a].points[0], world.bodies[b].points[0]};
  const ParticleId hinge = add_hinge(world, both);
  step(world);
  CHECK(world.contacts.list.empty());
  cut(world, hinge);
  step(world);
  CHECK_FALSE(world.contacts.list.empty());
}

TEST_CASE("Welded bodies do not collide") {
  World world;
  const BodyId a = add(world, shape(unit_box), zero3()), b = add(world, shape(unit_box), vec(0.5, 0, 0));
  add_weld(world, a, b);
  step(world);
  CHECK(world.contacts.list.empty());
}

TEST_CASE("What was built into each other is opened slowly") {
  World world;
  world.settings.gravity = zero3();
  const BodyId a = add(world, shape(unit_box), vec(0, 0, 0)), b = add(world, shape(unit_box), vec(0.5, 0.1, 0));
  double fastest = 0.0;
  while (world.time < 2.0) {
    const Vec3 before = world.motion_of(a).x;
    step(world);
    fastest = std::fmax(fastest, norm(world.motion_of(a).x - before) / world.settings.step);
  }
  CHECK(fastest <= 1.3);
  CHECK(deepest(world) < 1e-3);
  CHECK(kinetic_energy(world.motion_of(b)) < 1e-12);
}

TEST_CASE("A world without shapes has no contacts and no finder") {
  World world;
  add_links(world, 3, 1.0, true);
  for (BodyId id : world.bodies.ids())
    for (ShapeId s : std::vector<ShapeId>(world.bodies[id].shapes)) remove(world, s);
  advance(world, 0.1);
  CHECK(world.contact_finder == nullptr);
}

TEST_CASE("A merged body keeps the shapes of both, a removed one leaves none") {
  World world;
  const BodyId a = add(world, shape(unit_box), vec(0, 0, 0)), b = add(world, shape(BallShape{0.5}), vec(2, 0, 0));
  merge(world, a, b);
  REQUIRE(world.bodies[a].shapes.size() == 2);
  const Pose ball = pose_of(world, world.shapes[world.bodies[a].shapes[1]]);
  CHECK(norm(ball.x - vec(2, 0, 0)) < 1e-14);
  remove(world, a);
  CHECK(world.shapes.empty());
}

TEST_CASE("Integrators that cannot move what touches say so") {
  World world;
  world.settings.integrator = Integrator::suzuki4;
  add(world, shape(unit_box), zero3());
  step(world);
  CHECK(world.failure.find("moves nothing that touches") != std::string::npos);
}
