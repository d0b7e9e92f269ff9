// Friction against rolling and spinning, against closed forms.
#include <catch2/catch.hpp>
#include <cmath>

#include "edit/edit.hpp"
#include "measure/measure.hpp"
#include "step/step.hpp"

using namespace pantin;

namespace {

constexpr double g = 9.81, radius = 0.5;

void add_floor(World& world, double rolling, double spinning, double slope = 0.0) {
  ShapeDef def;
  def.geometry = HalfSpaceShape{};
  def.material.rolling = rolling;
  def.material.spinning = spinning;
  const double up = -M_PI / 4;
  def.orientation = Quat{std::cos(slope / 2), 0, 0, -std::sin(slope / 2)} * Quat{std::cos(up), std::sin(up), 0, 0};
  add_shape(world, def);
}

BodyId add_ball(World& world, Vec3 at, Vec3 velocity, Vec3 spin) {
  BodyDef body;
  body.shapes.emplace_back();
  body.shapes[0].geometry = BallShape{radius};
  body.at = at;
  body.velocity = velocity;
  body.spin = spin;
  body.mass = 2.0;
  return add_body(world, body);
}

}  // namespace

TEST_CASE("A rolling ball slows down by 5/7 g rolling/radius, and stops for good") {
  const double hz = GENERATE(60.0, 240.0);
  World world;
  world.settings.step = 1.0 / hz;
  add_floor(world, 0.05, 0.0);
  const double v = 2.0, slows = 5.0 / 7 * g * 0.05 / radius;
  const BodyId ball = add_ball(world, vec(0, radius, 0), vec(v, 0, 0), vec(0, 0, -v / radius));
  advance(world, 1.0);
  CHECK(world.motion_of(ball).p[0] / 2.0 == Approx(v - slows).epsilon(1e-6));
  advance(world, 4.0);
  const Vec3 there = world.motion_of(ball).x;
  CHECK(there[0] == Approx(v * v / (2 * slows)).epsilon(2.0 / hz));
  advance(world, 5.0);
  CHECK(norm(world.motion_of(ball).x - there) < 1e-9);
}

TEST_CASE("A ball that spins on the spot slows down by spinning m g over its inertia") {
  World world;
  add_floor(world, 0.0, 0.01);
  const BodyId ball = add_ball(world, vec(0, radius, 0), zero3(), vec(0, 2, 0));
  advance(world, 1.0);
  CHECK(angular_velocity(world.motion_of(ball))[1] == Approx(2.0 - 0.01 * g / (0.4 * radius * radius)).epsilon(1e-6));
  advance(world, 3.0);
  CHECK(norm(angular_velocity(world.motion_of(ball))) < 1e-5);
}

TEST_CASE(
    "A ball stays on a slope whose tangent is below rolling/radius, and rolls down a steeper one as fast as it "
    "should") {
  const double part = GENERATE(0.99, 1.01);
  const double rolling = 0.1, slope = std::atan(part * rolling / radius);
  World world;
  add_floor(world, rolling, 0.0, slope);
  const Vec3 up = vec(std::sin(slope), std::cos(slope), 0), along = vec(std::cos(slope), -std::sin(slope), 0);
  const BodyId ball = add_ball(world, up * radius, zero3(), zero3());
  advance(world, 4.0);
  const double rolled = dot(world.motion_of(ball).x - up * radius, along);
  const double wanted = part < 1.0 ? 0.0 : 8.0 * 5.0 / 7 * g * (std::sin(slope) - std::cos(slope) * rolling / radius);
  CHECK(std::fabs(rolled - wanted) < (part < 1.0 ? 1e-7 : 1e-3 * wanted));
}

TEST_CASE("Balls that roll over each other lose energy only") {
  World world;
  add_floor(world, 0.02, 0.01);
  for (int i = 0; i < 10; i++)
    add_ball(world, vec(1.05 * (i % 3), 0.5 + 1.1 * (i / 3), 0.4 * (i % 2)), vec(i % 4 - 1.5, 0, 0.3 * i),
             vec(i, 2, -i));
  double last = infinity, start = 0.0, most_rise = 0.0;
  for (int i = 0; i < 4 * 240; i++) {
    step(world);
    const Energy e = energy(world);
    const double now = e.kinetic + e.potential;
    if (i == 0) start = now;
    most_rise = std::fmax(most_rise, now - last);
    last = now;
  }
  CHECK(most_rise < 1e-5 * start);
}
