// Impacts that run through what touches, against the laws of impact of two.
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "edit/constrain.hpp"
#include "edit/edit.hpp"
#include "measure/measure.hpp"
#include "step/step.hpp"

using namespace pantin;

namespace {

ShapeDef shape(Geometry geometry, double restitution) {
  ShapeDef def;
  def.geometry = std::move(geometry);
  def.material.restitution = restitution;
  return def;
}

BodyId add_ball(World& world, double x, double speed, double restitution, double mass = 1.0) {
  BodyDef body;
  body.shapes = {shape(BallShape{0.5}, restitution)};
  body.at = vec(x, 0, 0);
  body.velocity = vec(speed, 0, 0);
  body.mass = mass;
  return add_body(world, body);
}

double speed_of(const World& world, BodyId body) { return world.motion_of(body).p[0] / world.motion_of(body).mass; }

/// A wall that faces along +x, at x.
void add_wall(World& world, double x, double restitution) {
  ShapeDef def = shape(HalfSpaceShape{}, restitution);
  def.at = vec(x, 0, 0);
  def.orientation = {std::cos(M_PI / 4), 0, std::sin(M_PI / 4), 0};
  add_shape(world, def);
}

void make_weightless(World& world, double hz) {
  world.settings.gravity = zero3();
  world.settings.step = 1.0 / hz;
}

}  // namespace

TEST_CASE("As many balls fly off a row as flew into it") {
  const int coming = GENERATE(1, 2, 3), standing = 5 - coming;
  const double hz = GENERATE(60.0, 240.0);
  World world;
  make_weightless(world, hz);
  std::vector<BodyId> balls;
  for (int i = 0; i < coming; i++) balls.push_back(add_ball(world, i - coming - 0.3, 2.0, 1.0));
  for (int i = 0; i < standing; i++) balls.push_back(add_ball(world, i, 0.0, 1.0));
  advance(world, 0.5);
  for (int i = 0; i < 5; i++)
    CHECK(std::fabs(speed_of(world, balls[static_cast<std::size_t>(i)]) - (i < 5 - coming ? 0.0 : 2.0)) < 1e-9);
}

TEST_CASE("A row of balls of other masses hands on what impacts of two give") {
  const double e = GENERATE(1.0, 0.6);
  const std::vector<double> masses = {1.0, 2.0, 0.5};
  World world;
  make_weightless(world, 240.0);
  std::vector<BodyId> balls = {add_ball(world, -1.2, 3.0, e, masses[0]), add_ball(world, 0.0, 0.0, e, masses[1]),
                               add_ball(world, 1.0, 0.0, e, masses[2])};
  advance(world, 0.2);
  std::vector<double> v = {3.0, 0.0, 0.0};
  const auto hit = [&](std::size_t i) {
    const double m = masses[i], n = masses[i + 1], p = (1 + e) * (v[i] - v[i + 1]) * m * n / (m + n);
    v[i] -= p / m;
    v[i + 1] += p / n;
  };
  hit(0);
  hit(1);
  if (v[0] > v[1]) hit(0);
  for (std::size_t i = 0; i < 3; i++) CHECK(std::fabs(speed_of(world, balls[i]) - v[i]) < 1e-9);
}

TEST_CASE("A small ball behind a large one leaves a wall at nearly three times its speed") {
  World world;
  make_weightless(world, 240.0);
  add_wall(world, 0.0, 1.0);
  const BodyId large = add_ball(world, 0.6, -2.0, 1.0, 1000.0), small = add_ball(world, 1.6, -2.0, 1.0, 1.0);
  advance(world, 0.2);
  const double common = (1000.0 * 2.0 - 2.0) / 1001.0;
  CHECK(std::fabs(speed_of(world, large) - (2 * common - 2.0)) < 1e-9);
  CHECK(std::fabs(speed_of(world, small) - (2 * common + 2.0)) < 1e-9);
}

TEST_CASE("What rebounds with friction gains no energy, whatever strikes at once") {
  World world;
  const double hz = GENERATE(60.0, 240.0);
  world.settings.step = 1.0 / hz;
  ShapeDef floor = shape(HalfSpaceShape{}, 1.0);
  floor.orientation = {std::cos(M_PI / 4), -std::sin(M_PI / 4), 0, 0};
  add_shape(world, floor);
  for (int i = 0; i < 12; i++) {
    BodyDef body;
    body.shapes = {shape(i % 2 ? Geometry{BoxShape{vec(0.3, 0.2, 0.4)}} : Geometry{BallShape{0.3}}, 0.9)};
    body.at = vec(0.4 * (i % 3), 1 + 0.7 * i, 0.3 * (i % 4));
    body.spin = vec(3.0 * (i % 5), -4, 2.0 * i);
    add_body(world, body);
  }
  keep_ledger(world);
  double last = infinity, start = 0.0, most_rise = 0.0;
  for (int i = 0; i < 4 * hz; i++) {
    step(world);
    const Energy e = energy(world);
    const double now = e.kinetic + e.potential - world.ledger.given[static_cast<std::size_t>(Source::push_out)];
    if (i == 0) start = now;
    most_rise = std::fmax(most_rise, now - last);
    last = now;
  }
  CHECK(most_rise < 1e-5 * start);
}

TEST_CASE("A cradle on hinges swings on with its energy") {
  World world;
  std::vector<BodyId> balls;
  for (int i = 0; i < 5; i++) {
    const double angle = i == 0 ? -0.5 : 0.0;
    BodyDef body;
    body.shapes = {shape(BallShape{0.1}, 1.0)};
    body.shapes[0].material.friction = 0.0;
    body.at = vec(0.2 * i + std::sin(angle), 1 - std::cos(angle), 0);
    body.orientation = {std::cos(angle / 2), 0, 0, std::sin(angle / 2)};
    PointDef eye;
    eye.at = vec(0, 1, 0);
    body.points = {eye};
    balls.push_back(add_body(world, body));
    add_nail(world, world.bodies[balls.back()].points[0]);
  }
  double second = 0.0, last = 0.0;
  for (int i = 0; i < 6 * 240; i++) {
    step(world);
    const auto away = [&](std::size_t k) { return world.motion_of(balls[k]).x[0] - 0.2 * static_cast<double>(k); };
    if (world.time > 3.0) second = std::fmin(second, away(0));
    last = std::fmax(last, away(4));
  }
  CHECK(last == Approx(std::sin(0.5)).epsilon(0.02));
  CHECK(-second == Approx(std::sin(0.5)).epsilon(0.05));
}
