// What friction and impact take, by who touches.
#include <catch2/catch.hpp>
#include <cmath>
#include <map>

#include "edit/edit.hpp"
#include "measure/measure.hpp"
#include "step/step.hpp"

using namespace pantin;

namespace {

constexpr double g = 9.81;

BodyId add(World& world, Geometry geometry, Vec3 at, Vec3 velocity = zero3(), double mass = 1.0) {
  BodyDef body;
  body.shapes.emplace_back();
  body.shapes[0].geometry = std::move(geometry);
  body.at = at;
  body.velocity = velocity;
  body.mass = mass;
  return add_body(world, body);
}

ShapeId add_floor(World& world) {
  ShapeDef def;
  def.geometry = HalfSpaceShape{};
  def.orientation = Quat{std::cos(M_PI / 4), -std::sin(M_PI / 4), 0, 0};
  return add_shape(world, def);
}

const BoxShape unit_box = {vec(0.5, 0.5, 0.5)};

void run(World& world, double seconds) {
  for (const double end = world.time + seconds; world.time < end - 1e-9;) step(world);
}

double sum(const World& world) {
  double all = 0.0;
  for (const TouchHeat& one : world.contacts.heat) all += one.heat;
  return all;
}

double of_ledger(const World& world) { return -world.ledger.given[static_cast<std::size_t>(Source::contact)]; }

/// Boxes and balls that fall on each other and on a floor, among them a chain whose links collide.
void add_heap(World& world) {
  add_floor(world);
  PointDef left, right;
  left.at = vec(-0.6, 0, 0);
  right.at = vec(0.6, 0, 0);
  BodyId last;
  for (int i = 0; i < 24; i++) {
    const Vec3 at = vec(0.3 * (i % 3), 0.7 + 1.1 * (i / 3), 0.25 * (i % 4));
    if (i % 2)
      add(world, BallShape{0.4}, at);
    else
      add(world, BoxShape{vec(0.4, 0.3, 0.5)}, at + vec(3, 0, 0), vec(-4, 0, 0));
  }
  for (int i = 0; i < 5; i++) {
    BodyDef link;
    link.shapes.emplace_back();
    link.shapes[0].geometry = BoxShape{vec(0.5, 0.1, 0.1)};
    link.points = {left, right};
    link.mass = 1.0;
    link.at = vec(-2 + 1.2 * i, 8, 0.3);
    const BodyId body = add_body(world, link);
    if (last) {
      const PointId ring[2] = {world.bodies[last].points[1], world.bodies[body].points[0]};
      add_hinge(world, ring);
    }
    last = body;
  }
}

}  // namespace

TEST_CASE("contact heat: a box that slides until it stops gives all of its energy to it and the floor") {
  World world;
  const ShapeId floor = add_floor(world);
  const double mass = 2.0, speed = GENERATE(1.0, 3.0);
  const BodyId box = add(world, unit_box, vec(0, 0.5, 0), vec(speed, 0, 0), mass);
  world.contacts.heat_kept = true;
  run(world, speed / (0.5 * g) + 0.5);
  REQUIRE(world.contacts.heat.size() == 1);
  CHECK(world.contacts.heat[0].pair == TouchPair{box, floor});
  CHECK(world.contacts.heat[0].heat == Approx(0.5 * mass * speed * speed).epsilon(1e-6));
}

TEST_CASE("contact heat: two that strike head-on and stay together lose what an inelastic impact takes") {
  World world;
  world.settings.gravity = zero3();
  const BodyId a = add(world, BallShape{0.5}, vec(-1, 0, 0), vec(3, 0, 0), 2.0);
  const BodyId b = add(world, BallShape{0.5}, vec(1, 0, 0), zero3(), 1.0);
  world.contacts.heat_kept = true;
  run(world, 1.0);
  REQUIRE(world.contacts.heat.size() == 1);
  CHECK(world.contacts.heat[0].pair == TouchPair{a, b});
  CHECK(world.contacts.heat[0].heat == Approx(0.5 * 2.0 / 3.0 * 9.0).epsilon(1e-9));
}

TEST_CASE("contact heat: of three boxes the two that rub take it, and what is pressed at rest takes nothing") {
  World world;
  const ShapeId floor = add_floor(world);
  const BodyId base = add(world, BoxShape{vec(5, 0.5, 5)}, vec(0, 0.5, 0), zero3(), 1000.0);
  const BodyId lower = add(world, unit_box, vec(0, 1.5, 0));
  const BodyId rider = add(world, unit_box, vec(3, 1.5, 0), vec(-1, 0, 0));  // stops before it is there
  world.contacts.heat_kept = true;
  run(world, 1.0);
  std::map<TouchPair, double> heat;
  for (const TouchHeat& one : world.contacts.heat) heat[one.pair] = one.heat;
  REQUIRE(heat.size() == 3);
  CHECK(heat.at({base, rider}) == Approx(0.5).epsilon(1e-6));
  CHECK(std::fabs(heat.at({base, lower})) < 1e-9);
  CHECK(std::fabs(heat.at({base, floor})) < 2.0 * 1002 * g * 1e-8);  // which it sinks in under its load
}

TEST_CASE("contact heat: the sum over all pairs is the ledger's line, in a heap with hinges, also when things go") {
  World world;
  add_heap(world);
  world.settings.step = GENERATE(1.0 / 240, 1.0 / 60);
  run(world, 0.25);
  const double before = of_ledger(world);
  world.contacts.heat_kept = true;
  run(world, 0.5);
  const std::size_t pairs = world.contacts.heat.size();
  CHECK(pairs > 15);
  CHECK(of_ledger(world) - before > 10.0);
  CHECK(sum(world) == Approx(of_ledger(world) - before).epsilon(1e-9));
  remove(world, world.bodies.ids()[3]);
  run(world, 0.5);
  CHECK(world.contacts.heat[0].pair == TouchPair{});
  CHECK(world.contacts.heat[0].heat != 0.0);
  CHECK(sum(world) == Approx(of_ledger(world) - before).epsilon(1e-9));
}

TEST_CASE("contact heat: a ball that rolls until friction against rolling stops it gives all of its energy") {
  World world;
  const double radius = 0.5, speed = 1.0;
  set_rolling(world, add_floor(world), 0.05);
  const BodyId ball = add(world, BallShape{radius}, vec(0, radius, 0), vec(speed, 0, 0));
  set_rolling(world, world.bodies[ball].shapes[0], 0.05);
  set_spin(world, ball, vec(0, 0, -speed / radius));
  world.contacts.heat_kept = true;
  run(world, 4.0);
  REQUIRE(world.contacts.heat.size() == 1);
  CHECK(world.contacts.heat[0].heat == Approx(0.7 * speed * speed).epsilon(1e-6));
}

TEST_CASE("contact heat: what a belt gives is below 0") {
  World world;
  const ShapeId floor = add_floor(world);
  set_surface_velocity(world, floor, vec(2, 0, 0));
  add(world, unit_box, vec(0, 0.5, 0), zero3(), 3.0);
  world.contacts.heat_kept = true;
  run(world, 1.0);
  REQUIRE(world.contacts.heat.size() == 1);
  CHECK(world.contacts.heat[0].heat == Approx(-0.5 * 3.0 * 4.0).epsilon(1e-6));
}

TEST_CASE("contact heat: asking changes no bit, and nothing is kept where nobody asks") {
  World worlds[2];
  for (World& world : worlds) {
    add_heap(world);
    world.contacts.heat_kept = &world == &worlds[1];
    run(world, 1.0);
  }
  CHECK(state_hash(worlds[0]) == state_hash(worlds[1]));
  CHECK(worlds[0].contacts.heat.empty());
  CHECK(worlds[0].contacts.new_heat.empty());
}
