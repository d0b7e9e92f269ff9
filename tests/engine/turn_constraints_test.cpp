// Constraints that tie rotations, against closed forms.
#include <catch2/catch.hpp>
#include <cmath>

#include "constraints/geometry.hpp"
#include "constraints/kind.hpp"
#include "edit/assemble.hpp"
#include "edit/constrain.hpp"
#include "measure/measure.hpp"
#include "measure/query.hpp"
#include "snapshot/snapshot.hpp"
#include "step/step.hpp"
#include "support/cases.hpp"

using namespace pantin;
using Catch::Contains;

namespace {

constexpr double pi = 3.14159265358979323846;
const Vec3 x_axis = vec(1, 0, 0), y_axis = vec(0, 1, 0), z_axis = vec(0, 0, 1);

/// A rod of 1 kg and 1 m along x from `left`.
BodyId rod_from(World& world, Vec3 left, double mass = 1.0) {
  BodyDef def;
  def.at = left + vec(0.5, 0, 0);
  return cases::add_rod_body(world, mass, 1.0, def);
}

BodyId post(World& world, Vec3 at) {
  BodyDef def;
  def.at = at;
  def.mass = 1;
  def.inertia = diagonal(vec(1, 1, 1));
  def.points.resize(1);
  return add_body(world, def);
}

PointId head(const World& world, BodyId body) { return world.bodies[body].points[0]; }
PointId tail(const World& world, BodyId body) { return world.bodies[body].points[1]; }
Vec3 spin(const World& world, BodyId body) { return angular_velocity(world.motion_of(body)); }

/// Largest |energy - start - work| / largest kinetic energy and largest gap while it runs.
Accuracy run(World& world, double until) {
  advance(world, until);
  REQUIRE(world.failure.empty());
  return world.worst;
}

}  // namespace

TEST_CASE("a body on a hinge with an axis swings about it as a compound pendulum does") {
  World world;
  const BodyId wall = post(world, vec(0, 0, 0));
  add_nail(world, head(world, wall));
  add_orient(world, wall);
  const double lean = 0.05;  // [rad] from the vertical
  BodyDef def;
  def.at = vec(0.5 * std::sin(lean), -0.5 * std::cos(lean), 0);
  const double half = 0.5 * (lean - 0.5 * pi);
  def.orientation = {std::cos(half), 0, 0, std::sin(half)};
  const BodyId door = cases::add_rod_body(world, 1, 1, def);
  const PointId points[] = {head(world, wall), head(world, door)};
  HingeDef hinge;
  hinge.axis = z_axis;
  add_hinge(world, points, hinge);
  const Mat3 inertia = cases::rod_inertia(1, 1);
  const double about_end = inertia[2][2] + 0.25;
  const double period =
      2.0 * pi * std::sqrt(about_end / (9.81 * 0.5)) * (1.0 + lean * lean / 16.0 + 11.0 * std::pow(lean, 4) / 3072.0);
  world.settings.step = period / 400;
  double last = 1, crossed = 0;
  while (world.time < 1.2 * period) {
    const double before = spin(world, door)[2], t = world.time;
    step(world);
    const double now = spin(world, door)[2];
    if (before < 0.0 && now >= 0.0 && t > 0.1 * period)
      last = t + world.settings.step * before / (before - now), crossed++;
    REQUIRE(std::fabs(spin(world, door)[0]) + std::fabs(spin(world, door)[1]) < 1e-10);
  }
  CHECK(world.worst.constraint < 1e-10);
  CHECK(world.worst.energy < 1e-9);
  INFO(last << " " << period);
  CHECK(std::fabs(last / period - 0.5) < 3e-5);
}

TEST_CASE("a thrown hinge with an axis keeps momentum, angular momentum and energy") {
  World world;
  world.settings.gravity = zero3();
  const BodyId a = rod_from(world, zero3()), b = rod_from(world, vec(1, 0, 0), 2.0);
  const PointId points[] = {tail(world, a), head(world, b)};
  HingeDef hinge;
  hinge.axis = vec(0, 1, 1);
  add_hinge(world, points, hinge);
  set_spin(world, a, vec(1, 2, 3));
  set_spin(world, b, vec(1, -3, 2));
  step(world);
  const Things all = everything(world);
  const Vec3 p = momentum(world, all), L = angular_momentum(world, all);
  const Accuracy worst = run(world, 5.0);
  CHECK(worst.constraint < 1e-10);
  CHECK(worst.energy < 1e-9);
  CHECK(norm(momentum(world, all) - p) < 1e-12);
  CHECK(norm(angular_momentum(world, all) - L) < 1e-11);
  const Vec3 axis_a = rotate(orientation(world, a), direction(vec(0, 1, 1)));
  CHECK(norm(axis_a - rotate(orientation(world, b), direction(vec(0, 1, 1)))) < 1e-10);
}

namespace {

/// Largest sine between an axis, given in the world where two bodies were at rest unturned, as each has turned it.
double off_axis(const World& world, BodyId a, BodyId b, Vec3 axis) {
  return norm(cross(rotate(orientation(world, a), axis), rotate(orientation(world, b), axis)));
}

}  // namespace

TEST_CASE("pairs of a hinge keep the axis they were given while others join and leave it") {
  World world;
  world.settings.gravity = zero3();
  std::vector<BodyId> bodies;
  std::vector<PointId> points;
  for (int i = 0; i < 5; i++) {
    BodyDef def;
    for (Vec3 at : {zero3(), vec(0.3, 0.1, 0), vec(0, 0.2, 0.4)}) {
      PointDef p;
      p.at = at;
      p.mass = 1.0;
      def.points.push_back(p);
    }
    bodies.push_back(add_body(world, def));
    points.push_back(world.bodies[bodies.back()].points[0]);
    set_spin(world, bodies.back(), vec(1.0 + i, -2.0, 0.5 * i));
  }
  const auto join = [&](std::vector<int> some, std::optional<Vec3> axis) {
    std::vector<PointId> ends;
    for (int i : some) ends.push_back(points[static_cast<std::size_t>(i)]);
    HingeDef def;
    def.axis = axis;
    return add_hinge(world, ends, def);
  };
  join({0, 1}, y_axis);     // a knuckle turns about y
  join({1, 2}, x_axis);     // and a wheel on it about x
  join({3, 4, 2}, z_axis);  // the wheel brings all that it joins; these three share an axis
  const ParticleId ring = world.points[points[0]].particle;
  REQUIRE(world.particles[ring].axes.size() == 4);
  const auto expect = [&](std::vector<double> wanted) {
    advance(world, world.time + 0.5);
    CHECK(world.failure == "");
    CHECK(world.stats.fallback_steps == 0);
    const std::vector<double> found = {off_axis(world, bodies[0], bodies[1], y_axis),
                                       off_axis(world, bodies[1], bodies[2], x_axis),
                                       off_axis(world, bodies[4], bodies[2], z_axis)};
    for (std::size_t i = 0; i < found.size(); i++) CHECK((found[i] < 1e-9) == (wanted[i] == 0.0));
  };
  expect({0, 0, 0});
  const Snapshot before = take_snapshot(world);
  cut(world, ring, bodies[3]);  // the first of the three; the others keep theirs
  CHECK(world.particles[ring].axes.size() == 3);
  expect({0, 0, 0});
  cut(world, ring, bodies[1]);  // takes both of its own along
  CHECK(world.particles[ring].axes.size() == 1);
  expect({1, 1, 0});
  restore(world, before);
  CHECK(world.particles[ring].axes.size() == 4);
  expect({0, 0, 0});
}

TEST_CASE("a hinge keeps the axis of a body that is merged into another one on it") {
  World world;
  world.settings.gravity = zero3();
  const BodyId a = rod_from(world, zero3()), b = rod_from(world, zero3()), c = rod_from(world, zero3());
  const PointId knuckle[] = {head(world, a), head(world, b)}, wheel[] = {head(world, b), head(world, c)};
  HingeDef hinge;
  add_hinge(world, knuckle, hinge);
  hinge.axis = y_axis;
  add_hinge(world, wheel, hinge);
  merge(world, a, b);
  set_spin(world, a, vec(1, 2, 3));
  advance(world, 0.5);
  CHECK(world.failure == "");
  CHECK(off_axis(world, a, c, y_axis) < 1e-9);
}

TEST_CASE("loops of hinges with axes keep their energy, and their velocities need no factor of their own") {
  World world;
  std::vector<BodyId> bars[2];  // a trellis, let go
  for (int layer = 0; layer < 2; layer++)
    for (int i = 0; i < 4; i++) {
      BodyDef def;
      def.points.resize(4);
      for (int j = 0; j < 4; j++) {
        PointDef& p = def.points[static_cast<std::size_t>(j)];
        p.at = layer == 0 ? vec(j, 0.5 * i, 0) : vec(i, 0.5 * j, 0);
        p.mass = 1.0;
      }
      bars[layer].push_back(add_body(world, def));
    }
  HingeDef hinge;
  hinge.axis = z_axis;
  for (std::size_t i = 0; i < 4; i++)
    for (std::size_t j = 0; j < 4; j++) {
      const PointId pair[] = {cases::point_of(world, bars[0][i], j), cases::point_of(world, bars[1][j], i)};
      add_hinge(world, pair, hinge);
    }
  add_nail(world, cases::point_of(world, bars[0][0], 0));
  advance(world, 0.4);
  CHECK(world.failure == "");
  CHECK(world.stats.projections <= 3);
  CHECK(world.worst.energy <= 1e-9);
  CHECK(world.error.constraint <= 1e-9);
  CHECK(world.stats.fallback_steps == 0);
}

TEST_CASE("a welded arm bears its weight, and breaks where it is told to") {
  World world;
  const BodyId wall = post(world, vec(0, 0, 0)), arm = rod_from(world, zero3(), 3.0);
  add_nail(world, head(world, wall));
  add_orient(world, wall);
  const ConstraintId weld = add_weld(world, arm, wall);
  run(world, 0.5);
  CHECK(world.worst.constraint < 1e-11);
  CHECK(norm(world.constraints[weld].force - vec(0, 3 * 9.81, 0)) < 1e-8);
  CHECK(norm(world.constraints[weld].torque - vec(0, 0, 3 * 9.81 * 0.25)) < 1e-8);  // about its position, x = 0.25
  CHECK(std::fabs(world.motion_of(arm).x[1]) < 1e-11);
  set_breaks_at(world, weld, {infinity, 7.0, infinity});
  step(world);
  CHECK_FALSE(world.constraints.alive(weld));
  REQUIRE(world.notices.size() == 1);
  CHECK(world.notices[0].kind == Notice::Kind::broke);
  CHECK(std::fabs(world.notices[0].force - 3 * 9.81 * 0.25) < 1e-6);
  run(world, 0.6);
  CHECK(world.motion_of(arm).x[1] < -0.01);
}

TEST_CASE("a motor of a bounded torque spins up at torque over inertia, then holds its speed") {
  World world;
  world.settings.gravity = zero3();
  const BodyId wheel = post(world, zero3());
  set_own_inertia(world, wheel, diagonal(vec(2, 3, 4)));
  const auto bounded = [&](double speed) {
    MotorDef def;
    def.axis = z_axis;
    def.speed = speed;
    def.max_torque = 8.0;
    return def;
  };
  const ConstraintId motor = add_motor(world, wheel, {}, bounded(5.0));
  run(world, 1.0);
  CHECK(std::fabs(spin(world, wheel)[2] - 2.0) < 1e-9);
  CHECK(norm(world.constraints[motor].torque) <= 8.0 * (1 + 1e-9));
  run(world, 3.0);
  CHECK(std::fabs(spin(world, wheel)[2] - 5.0) < 1e-9);
  CHECK(norm(world.constraints[motor].torque) < 1e-6);
  CHECK(world.worst.energy < 1e-9);
  set_length(world, motor, -1.0);
  for (int i = 0; i < 100; i++) {
    step(world);
    REQUIRE(norm(world.constraints[motor].torque) <= 8.0 * (1 + 1e-9));
  }
}

TEST_CASE("a motor between two free bodies keeps angular momentum; its work is what they gain") {
  World world;
  world.settings.gravity = zero3();
  const BodyId a = post(world, zero3()), b = post(world, zero3());
  set_own_inertia(world, a, diagonal(vec(0.5, 2, 2)));
  MotorDef def;
  def.axis = vec(1, 2, 0);
  def.speed = 30.0;
  def.max_torque = 20.0;
  add_motor(world, a, b, def);
  const PointId points[] = {head(world, a), head(world, b)};
  HingeDef hinge;
  hinge.axis = def.axis;
  add_hinge(world, points, hinge);
  for (int i = 0; i < 240; i++) {
    step(world);
    REQUIRE(norm(angular_momentum(world, everything(world))) < 1e-11);
  }
  CHECK(world.worst.energy < 2e-4);  // the projection takes some, and gives nothing back where a motor works
  CHECK(std::fabs(dot(direction(def.axis), spin(world, a) - spin(world, b))) > 1.0);
}

TEST_CASE("a motor keeps an angle that is a function of time") {
  World world;
  const BodyId arm = rod_from(world, zero3());
  add_nail(world, head(world, arm));
  MotorDef def;
  def.axis = z_axis;
  def.angle = 0.0;
  def.number = [](double t) { return 0.5 - 0.5 * std::cos(3.0 * t); };
  const ConstraintId motor = add_motor(world, arm, {}, def);
  const double until = 4.0;
  run(world, until);
  const double wanted = 0.5 - 0.5 * std::cos(3.0 * until);
  CHECK(std::fabs(world.constraints[motor].angle - wanted) < 1e-10);
  CHECK(norm(world.motion_of(arm).x - 0.5 * vec(std::cos(wanted), std::sin(wanted), 0)) < 1e-9);
  CHECK(world.worst.energy < 1e-4);  // the projection takes some where targets move
}

TEST_CASE("what is far from its orientation, axis or angle approaches critically damped") {
  World world;
  world.settings.gravity = zero3();
  const double tau = 0.2, far = 2.0;
  const Quat turned = {std::cos(0.5 * far), std::sin(0.5 * far), 0, 0};
  OrientDef orient;
  orient.to = turned;
  orient.time_constant = tau;
  const BodyId a = post(world, zero3()), b = post(world, x_axis), c = post(world, y_axis);
  const ConstraintId first = add_orient(world, a, orient);
  AlignDef align{x_axis, vec(std::cos(far), std::sin(far), 0), 0.0, tau};
  const ConstraintId second = add_align(world, b, {}, align);
  MotorDef motor;
  motor.axis = vec(0, 1, 1);
  motor.angle = far;
  motor.time_constant = tau;
  const ConstraintId third = add_motor(world, c, {}, motor);
  for (int i = 0; i < 240; i++) {
    step(world);
    const double s = world.time / tau, wanted = far * (1 + s) * std::exp(-s);
    REQUIRE(std::fabs(norm(present_turn(world, world.constraints[first])) - wanted) < 0.01 * wanted + 1e-8);
    REQUIRE(std::fabs(present_value(world, world.constraints[second]) - wanted) < 0.01 * wanted + 1e-7);
    REQUIRE(std::fabs(far - world.constraints[third].angle - wanted) < 0.01 * wanted + 1e-8);
  }
  CHECK(world.worst.constraint < 1e-10);
  CHECK(world.worst.energy < 0.01);
}

TEST_CASE("an align draws axes apart that lie along one line") {
  World world;
  world.settings.gravity = zero3();
  const BodyId body = post(world, zero3());
  set_own_inertia(world, body, diagonal(vec(1, 2, 2.5)));
  const double along = GENERATE(1.0, -1.0);
  const ConstraintId align = add_align(world, body, {}, {x_axis, x_axis * along, 1.0, 0.1});
  run(world, 3.0);
  CHECK(std::fabs(present_value(world, world.constraints[align]) - 1.0) < 1e-10);
  CHECK(world.stats.fallback_steps == 0);
}

TEST_CASE("an align keeps the angle between two axes while all else turns") {
  World world;
  world.settings.gravity = zero3();
  const BodyId a = post(world, zero3()), b = post(world, x_axis);
  set_own_inertia(world, a, diagonal(vec(1, 2, 2.5)));
  set_spin(world, a, vec(3, 1, 2));
  set_spin(world, b, vec(-1, 2, 0));
  AlignDef def{x_axis, direction(vec(1, 1, 0)), {}, 0.1};
  const ConstraintId align = add_align(world, a, b, def);
  CHECK(std::fabs(world.constraints[align].number.now - 0.25 * pi) < 1e-14);
  step(world);
  const Vec3 L = angular_momentum(world, everything(world));
  const Accuracy worst = run(world, 5.0);
  CHECK(std::fabs(present_value(world, world.constraints[align]) - 0.25 * pi) < 1e-10);
  CHECK(worst.energy < 1e-9);
  CHECK(norm(angular_momentum(world, everything(world)) - L) < 1e-11);
}

TEST_CASE("a limit of an angle stops a swing, and does nothing before and after") {
  World world;
  const BodyId arm = rod_from(world, zero3());
  add_nail(world, head(world, arm));
  const ConstraintId limit = add_limit(world, arm, {}, z_axis, {-0.5, infinity, 0.1});
  double lowest = 0;
  for (int i = 0; i < 480; i++) {
    step(world);
    lowest = std::fmin(lowest, world.constraints[limit].angle);
    if (world.time < 0.2) REQUIRE(norm(world.constraints[limit].torque) == 0.0);
  }
  CHECK(world.failure.empty());
  CHECK(lowest > -0.5 - 1e-9);
  CHECK(std::fabs(world.constraints[limit].angle + 0.5) < 1e-9);
  CHECK(norm(spin(world, arm)) < 1e-9);
  CHECK(std::fabs(world.constraints[limit].torque[2] - 9.81 * 0.5 * std::cos(0.5)) < 1e-7);
  CHECK(world.worst.energy < 1e-9);
  set_spin(world, arm, vec(0, 0, 4));
  set_velocity(world, arm, cross(vec(0, 0, 4), world.motion_of(arm).x));
  step(world);
  CHECK(norm(world.constraints[limit].torque) < 1e-6);
  CHECK(std::fabs(spin(world, arm)[2] - 4) < 0.1);
}

TEST_CASE("constraints of rotations say what is wrong with what they are given") {
  World world;
  const BodyId a = post(world, zero3()), b = post(world, zero3());
  const ParticleId mass = add_particle(world, {});
  MotorDef motor;
  motor.axis = z_axis;
  CHECK_THROWS_WITH(add_motor(world, a, {}, motor), Contains("needs either speed") && Contains("or angle"));
  motor.speed = 1.0;
  motor.max_torque = -1.0;
  CHECK_THROWS_WITH(add_motor(world, a, {}, motor), Contains("max_torque must be > 0 N m"));
  motor.max_torque = 1.0;
  CHECK_THROWS_WITH(add_motor(world, a, a, motor), Contains("needs two bodies"));
  motor.axis = zero3();
  CHECK_THROWS_WITH(add_motor(world, a, b, motor), Contains("axis must not be vec(0, 0, 0)"));
  CHECK_THROWS_WITH(add_limit(world, a, b, z_axis, {2.0, 1.0, 0.1}),
                    Contains("min must be below max, got 2 and 1 rad"));
  CHECK_THROWS_WITH(add_limit(world, a, b, z_axis, {0.0, 1.0, -1.0}), Contains("time_constant must be > 0 s"));
  CHECK_THROWS_WITH(add_align(world, a, b, {x_axis, y_axis, 4.0, 0.1}), Contains("angle must be 0 to π rad, got 4"));
  HingeDef hinge;
  hinge.axis = x_axis;
  const PointId points[] = {head(world, a), world.particles[mass].points[0]};
  CHECK_THROWS_WITH(add_hinge(world, points, hinge), Contains("a free particle has no orientation"));
  CHECK(world.constraints.empty());
}
