// Particles that touch, against closed forms.
#include <catch2/catch.hpp>
#include <cmath>

#include "articulates/articulate.hpp"
#include "base/parallel.hpp"
#include "contacts/touching.hpp"
#include "edit/constrain.hpp"
#include "edit/edit.hpp"
#include "edit/emitter.hpp"
#include "measure/measure.hpp"
#include "snapshot/snapshot.hpp"
#include "step/step.hpp"
#include "support/balance.hpp"

using namespace pantin;

namespace {

constexpr double gravity_there = 9.81, grain_radius = 0.05;

ShapeDef of_shape(Geometry geometry, double friction = 0.5, double restitution = 0.0) {
  ShapeDef def;
  def.geometry = std::move(geometry);
  def.material.friction = friction;
  def.material.restitution = restitution;
  return def;
}

/// At height 0, inclined about z by an angle [rad], downhill along +x.
ShapeId inclined_floor(World& world, double friction = 0.5, double slope = 0.0) {
  ShapeDef def = of_shape(HalfSpaceShape{}, friction);
  const double up = -M_PI / 4;
  def.orientation = Quat{std::cos(slope / 2), 0, 0, -std::sin(slope / 2)} * Quat{std::cos(up), std::sin(up), 0, 0};
  return add_shape(world, def);
}

FamilyId solid_family(World& world, double friction = 0.5, double restitution = 0.0, std::string layer = "",
                      std::string name = "grain") {
  FamilyDef def;
  def.name = std::move(name);
  def.radius = grain_radius;
  def.solid.emplace();
  def.solid->friction = friction;
  def.solid->restitution = restitution;
  def.layer = std::move(layer);
  return add_family(world, def);
}

PointId grain(World& world, FamilyId family, Vec3 at, Vec3 velocity = zero3(), double mass = 1.0) {
  ParticleDef def;
  def.family = family;
  def.at = at;
  def.velocity = velocity;
  def.mass = mass;
  return world.particles[add_particle(world, def)].points[0];
}

BodyId of_body(World& world, const ShapeDef& def, Vec3 at, double mass) {
  BodyDef body;
  body.shapes = {def};
  body.at = at;
  body.mass = mass;
  return add_body(world, body);
}

double all_energy(const World& world) {
  const Energy e = energy(world);
  return e.kinetic + e.potential;
}

/// A sheet of n × n points on rods, level, its middle above the origin.
std::vector<PointId> level_sheet(World& world, FamilyId family, int n, double spacing, double height) {
  std::vector<PointId> points;
  for (int i = 0; i < n; i++)
    for (int j = 0; j < n; j++)
      points.push_back(grain(world, family, vec((i - 0.5 * (n - 1)) * spacing, height, (j - 0.5 * (n - 1)) * spacing),
                             zero3(), 0.01));
  const auto at = [&](int i, int j) { return points[static_cast<std::size_t>(i * n + j)]; };
  for (int i = 0; i < n; i++)
    for (int j = 0; j < n; j++) {
      if (i + 1 < n) add_rod(world, at(i, j), at(i + 1, j));
      if (j + 1 < n) add_rod(world, at(i, j), at(i, j + 1));
    }
  return points;
}

}  // namespace

TEST_CASE("A particle that loses nothing rises as high as it fell, for twenty bounces") {
  World world;
  world.settings.step = 1.0 / GENERATE(60.0, 240.0);
  inclined_floor(world);
  const PointId ball = grain(world, solid_family(world, 0.5, 1.0), vec(0, 2, 0));
  const double start = all_energy(world);
  double last = 0.0;
  for (int bounces = 0; bounces < 20;) {
    step(world);
    const double v = world.motion_of(ball).v[1];
    if (last < 0.0 && v > 0.0) bounces++;
    last = v;
    REQUIRE(world.time < 60.0);
  }
  CHECK(std::fabs(all_energy(world) - start) < 20 * 1e-8 * start);
}

TEST_CASE("A particle of restitution 0.8 has 0.64 of its energy after each bounce") {
  World world;
  inclined_floor(world);
  const PointId ball = grain(world, solid_family(world, 0.5, 0.8), vec(0, 2, 0));
  double expected = (2.0 - grain_radius) * gravity_there, last = 0.0;
  for (int bounces = 0; bounces < 5;) {
    step(world);
    REQUIRE(world.time < 60.0);
    const FreeMotion& m = world.motion_of(ball);
    if (last < 0.0 && m.v[1] > 0.0) {
      bounces++;
      expected *= 0.64;
      CHECK(std::fabs(0.5 * norm2(m.v) + gravity_there * (m.x[1] - grain_radius) - expected) < 1e-3 * expected);
    }
    last = m.v[1];
  }
}

TEST_CASE("A particle stays on a slope below the angle of friction, and slides above it as fast as it should") {
  const double part = GENERATE(0.99, 1.01), slope = std::atan(0.5 * part);
  World world;
  inclined_floor(world, 0.5, slope);
  const Vec3 up = vec(std::sin(slope), std::cos(slope), 0), along = vec(std::cos(slope), -std::sin(slope), 0);
  const PointId ball = grain(world, solid_family(world), up * grain_radius);
  constexpr double time = 4.0;
  advance(world, time);
  const double slid = dot(world.motion_of(ball).x, along);
  const double acceleration = gravity_there * (std::sin(slope) - 0.5 * std::cos(slope));
  CHECK(std::fabs(dot(world.motion_of(ball).x, up) - grain_radius) < 1e-8);
  if (part < 1.0)
    CHECK(std::fabs(slid) < 1e-6);
  else
    CHECK(std::fabs(slid - 0.5 * acceleration * time * time) < 1e-3 * slid);
}

TEST_CASE("A particle that strikes a box off its centre shares momentum and spin as the impact says") {
  World world;
  world.settings.gravity = zero3();
  const BodyId box = of_body(world, of_shape(BoxShape{vec(0.5, 0.5, 0.5)}, 0.0, 0.6), zero3(), 3.0);
  const PointId ball = grain(world, solid_family(world, 0.0, 0.6), vec(0.3, 1.0, 0), vec(0, -2, 0));
  advance(world, 0.5);
  const double inertia = 3.0 / 6.0, impulse = 1.6 * 2.0 / (1.0 + 1.0 / 3.0 + 0.3 * 0.3 / inertia);
  CHECK(world.motion_of(ball).v[1] == Approx(impulse - 2.0).epsilon(1e-9));
  CHECK(world.motion_of(box).p[1] == Approx(-impulse).epsilon(1e-9));
  CHECK(angular_velocity(world.motion_of(box))[2] == Approx(-0.3 * impulse / inertia).epsilon(1e-9));
}

TEST_CASE("Particles that rub on a body keep momentum and angular momentum") {
  World world;
  world.settings.gravity = zero3();
  const BodyId box = of_body(world, of_shape(BoxShape{vec(0.5, 0.5, 0.5)}), zero3(), 2.0);
  set_spin(world, box, vec(1, 2, 3));
  const FamilyId family = solid_family(world, 0.5, 0.3, "grain");
  set_rule(world, "grain", "grain", {0, 0, false, {}, {}});
  for (int i = 0; i < 20; i++)
    grain(world, family, vec(0.8 + 0.05 * i, 0.04 * i - 0.4, 0.3 - 0.02 * i), vec(-3, 0.5, 0.2), 0.1);
  const Balance before = balance_of(world);
  advance(world, 1.5);
  CHECK(norm(world.motion_of(box).p) > 1.0);
  const Balance after = balance_of(world);
  CHECK(norm(after.momentum - before.momentum) < 1e-12);
  CHECK(norm(after.angular - before.angular) < 1e-12);
}

TEST_CASE("Of two equal particles that meet head on each leaves with the other's velocity") {
  World world;
  world.settings.gravity = zero3();
  const FamilyId family = solid_family(world, 0.5, 1.0);
  const PointId a = grain(world, family, vec(-1, 0, 0), vec(3, 0, 0)), b = grain(world, family, vec(1, 0, 0));
  advance(world, 1.0);
  CHECK(norm(world.motion_of(a).v) < 1e-9);
  CHECK(norm(world.motion_of(b).v - vec(3, 0, 0)) < 1e-9);
}

TEST_CASE("A rope over a cylinder holds up to the ratio of its loads that friction allows, and slides above") {
  // Over a polygon a rope that turns by δ at a corner slides there from (1 + µ tan δ/2) / (1 - µ tan δ/2) on: for small δ e^µδ.
  constexpr int corners = 24;
  constexpr double friction = 0.3, way = 0.5 + grain_radius, turn = M_PI / corners;
  const auto of_corner = [&](double delta) {
    const double t = friction * std::tan(0.5 * delta);
    return (1.0 + t) / (1.0 - t);
  };
  const double most = std::pow(of_corner(turn), corners - 1) * std::pow(of_corner(0.5 * turn), 2);
  CHECK(most == Approx(std::exp(friction * M_PI)).epsilon(2e-3));
  const double part = GENERATE(0.98, 1.02);
  World world;
  ShapeDef beam = of_shape(CylinderShape{0.5, 1.0}, friction);
  add_shape(world, beam);
  const FamilyId family = solid_family(world, friction);
  constexpr double light = 1e-3, load = 1.0;
  std::vector<PointId> rope = {grain(world, family, vec(-way, -1, 0), zero3(), load * most * part)};
  for (int i = 0; i <= corners; i++)
    rope.push_back(grain(world, family, vec(-std::cos(i * turn), std::sin(i * turn), 0) * way, zero3(), light));
  rope.push_back(grain(world, family, vec(way, -1, 0), zero3(), load));
  for (std::size_t i = 0; i + 1 < rope.size(); i++) add_rod(world, rope[i], rope[i + 1]);
  advance(world, 0.5);
  const double sunk = -1.0 - world.motion_of(rope[0]).x[1];
  CHECK(world.error.constraint < 1e-11);
  if (part < 1.0)
    CHECK(std::fabs(sunk) < 1e-6);
  else
    CHECK(sunk > 1e-3);
}

TEST_CASE("A sheet on rods falls over a ball: rods keep, energy falls, nothing is in the ball") {
  World world;
  add_shape(world, of_shape(BallShape{0.4}));
  const std::vector<PointId> points = level_sheet(world, solid_family(world), 9, 0.12, 0.5);
  const double start = all_energy(world) + 1.0;
  double last = all_energy(world), rise = 0.0, deepest = 0.0, open = 0.0;
  while (world.time < 1.0) {
    step(world);
    rise = std::fmax(rise, all_energy(world) - last);
    last = all_energy(world);
    open = std::fmax(open, world.error.constraint);
    for (const PointId p : points) deepest = std::fmax(deepest, 0.4 + grain_radius - norm(world.motion_of(p).x));
  }
  CHECK(open < 1e-11);
  CHECK(rise < 5e-5 * start);
  CHECK(deepest < 1e-3);
}

TEST_CASE("Particles that touch have the same bits for any number of threads, and after a restore") {
  const auto build = [](World& world) {
    inclined_floor(world);
    of_body(world, of_shape(BoxShape{vec(0.3, 0.3, 0.3)}), vec(0, 0.3, 0), 1.0);
    const FamilyId family = solid_family(world);
    for (int i = 0; i < 60; i++) grain(world, family, vec(0.11 * (i % 4), 1.0 + 0.11 * (i / 8), 0.11 * (i / 4 % 2)));
    level_sheet(world, family, 5, 0.12, 3.0);
  };
  World one, four;
  build(one);
  build(four);
  four.workers = std::make_unique<Workers>(4);
  advance(one, 0.5);
  const Snapshot then = take_snapshot(one);
  advance(one, 1.0);
  advance(four, 1.0);
  const std::uint64_t end = state_hash(one);
  CHECK(state_hash(four) == end);
  restore(one, then);
  CHECK_FALSE(one.contacts.list.empty());
  advance(one, 1.0);
  CHECK(state_hash(one) == end);
}

TEST_CASE("What a particle touches is told, and parts when the particle is removed") {
  World world;
  const ShapeId floor = inclined_floor(world);
  const PointId ball = grain(world, solid_family(world), vec(0, grain_radius + 0.01, 0));
  const ParticleId particle = world.points[ball].own;
  watch(world, world.contacts, true);
  std::vector<Notice> told;
  const auto listen = [&] {
    world.notices.clear();
    step(world);
    told.insert(told.end(), world.notices.begin(), world.notices.end());
  };
  while (world.time < 0.5) listen();
  REQUIRE(told.size() == 1);
  CHECK(told[0].kind == Notice::Kind::touched);
  CHECK((told[0].touch.pair == TouchPair{particle, floor}));
  CHECK(norm(told[0].touch.at) < 1e-3);
  told.clear();
  remove(world, ball);
  CHECK(world.contacts.list.empty());
  listen();
  REQUIRE(told.size() == 1);
  CHECK(told[0].kind == Notice::Kind::parted);
}

TEST_CASE("Layers that do not collide let particles pass; without a solid family nothing touches") {
  const bool rule = GENERATE(true, false);
  World world;
  ShapeDef def = of_shape(BoxShape{vec(1, 0.1, 1)});
  def.layer = "water";
  add_shape(world, def);
  const FamilyId family = solid_family(world, 0.5, 0.0, "oil");
  set_rule(world, "oil", "water", {0, 0, !rule, {}, {}});
  const PointId ball = grain(world, family, vec(0, 0.5, 0));
  advance(world, 1.0);
  CHECK((world.motion_of(ball).x[1] < 0.0) == rule);
}

TEST_CASE("A particle in a hinge of a body does not touch that body; cut loose it does") {
  World world;
  world.settings.gravity = zero3();
  BodyDef def;
  def.shapes = {of_shape(BoxShape{vec(0.5, 0.5, 0.5)})};
  def.points = {PointDef{}};
  def.points[0].at = vec(0.48, 0, 0);
  const BodyId box = add_body(world, def);
  const PointId ball = grain(world, solid_family(world), vec(0.48, 0, 0));
  const PointId both[] = {ball, world.bodies[box].points[0]};
  const ParticleId hinge = add_hinge(world, both);
  step(world);
  CHECK(world.contacts.list.empty());
  cut(world, hinge);
  step(world);
  CHECK_FALSE(world.contacts.list.empty());
}

TEST_CASE("Particles of an emitter touch, and their contacts go with them") {
  World world;
  inclined_floor(world);
  EmitterDef def;
  def.family = solid_family(world);
  def.position.at = vec(0, 0.5, 0);
  def.velocity = vec(3, 0, 0);
  def.rate = 20;  // none is born in another
  def.shortest = def.longest = 1.0;
  add_emitter(world, def);
  double lowest = 1.0;
  while (world.time < 2.0) {
    step(world);
    for (const FreeMotion& m : world.free_motion) lowest = std::fmin(lowest, m.x[1]);
  }
  CHECK(world.points.size() <= 21);
  CHECK(world.contacts.list.size() > 5);
  CHECK(lowest > 0.95 * grain_radius);
}

TEST_CASE("What is solid needs a radius that stays") {
  World world;
  FamilyDef def;
  def.name = "dust";
  def.radius = 0.0;
  def.solid.emplace();
  CHECK_THROWS_WITH(add_family(world, def), Catch::Contains("radius > 0 m, got 0"));
  def.radius = {};
  def.solid->friction = -1.0;
  CHECK_THROWS_WITH(add_family(world, def), Catch::Contains("friction"));
  def.solid->friction = 0.5;
  def.solid->restitution = std::nan("");
  CHECK_THROWS_WITH(add_family(world, def), Catch::Contains("restitution must be from 0 to 1"));
  def.solid->restitution = 0.0;
  const FamilyId family = add_family(world, def);
  ParticleDef particle;
  particle.family = family;
  particle.radius = 0.0;
  CHECK_THROWS_WITH(add_particle(world, particle), Catch::Contains("solid family 'dust'"));
  particle.radius = 0.1;
  const ParticleId made = add_particle(world, particle);
  CHECK_THROWS_WITH(set_radius(world, made, 0.0), Catch::Contains("radius > 0 m"));
  FamilyDef soft;
  soft.name = "air";
  CHECK_THROWS_WITH(set_friction(world, add_family(world, soft), 0.1), Catch::Contains("it is not"));
}
