// Constraints that guide points, against closed forms.
#include <catch2/catch.hpp>
#include <chrono>
#include <cmath>

#include "constraints/kind.hpp"
#include "edit/constrain.hpp"
#include "measure/measure.hpp"
#include "model/path.hpp"
#include "step/step.hpp"
#include "support/cases.hpp"

using namespace pantin;
using Catch::Contains;

namespace {

constexpr double pi = 3.14159265358979323846, g = 9.81;

Passage through(PointId point) { return {point, zero3()}; }
Passage place(Vec3 at) { return {{}, at}; }

PointId mass_at(World& world, Vec3 at, double mass = 1.0) {
  ParticleDef def;
  def.at = at;
  def.mass = mass;
  return cases::point_of(world, add_particle(world, def));
}

std::shared_ptr<const Path> circle(double radius, int positions) {
  std::vector<Vec3> list;
  for (int i = 0; i < positions; i++)
    list.push_back(radius * vec(std::sin(2 * pi * i / positions), -std::cos(2 * pi * i / positions), 0));
  return std::make_shared<const Path>(std::move(list), true, true);
}

/// Time between two passes of x = 0 with v > 0.
double period_of(World& world, PointId point, double about) {
  std::vector<double> passes;
  while (world.time < 1.4 * about) {
    const double before = position(world, point)[0], t = world.time;
    step(world);
    const double now = position(world, point)[0];
    if (before < 0.0 && now >= 0.0) passes.push_back(t + world.settings.step * before / (before - now));
    if (before > 0.0 && now <= 0.0) passes.push_back(t + world.settings.step * before / (before - now));
  }
  REQUIRE(passes.size() >= 2);
  return 2.0 * (passes[1] - passes[0]);
}

}  // namespace

TEST_CASE("a point on an inclined plane slides down it at g sin") {
  World world;
  const double slope = 0.5;
  const Vec3 normal = vec(std::sin(slope), std::cos(slope), 0), down = vec(std::cos(slope), -std::sin(slope), 0);
  const PointId point = mass_at(world, zero3(), 2.0);
  const ConstraintId plane = cases::add_on_plane(world, point, 3.0 * normal);
  advance(world, 2.0);
  CHECK(norm(position(world, point) - down * (0.5 * g * std::sin(slope) * 4.0)) < 1e-10);
  CHECK(norm(world.constraints[plane].force - normal * (2.0 * g * std::cos(slope))) < 1e-8);
  CHECK(world.worst.constraint < 1e-10);
  CHECK(world.worst.energy < 1e-9);
}

TEST_CASE("a bead on a circle swings as a pendulum, its energy kept") {
  World world;
  world.settings.step = 1.0 / 480;
  const double start = 1.0;  // [rad]
  const auto wire = circle(1.0, 128);
  const PointId bead = mass_at(world, wire->position(128 * start / (2 * pi)));
  const ConstraintId path = add_on_path(world, bead, wire);
  const double k = std::sin(0.5 * start);
  const double period =
      2 * pi / std::sqrt(g) *
      (1 + k * k / 4 + 9 * std::pow(k, 4) / 64 + 25 * std::pow(k, 6) / 256 + 1225 * std::pow(k, 8) / 16384);
  CHECK(std::fabs(period_of(world, bead, period) / period - 1.0) < 1e-4);
  advance(world, 10.0);
  CHECK(world.failure.empty());
  CHECK(world.worst.constraint < 1e-10);
  CHECK(world.worst.energy < 1e-9);
  CHECK(world.stats.fallback_steps == 0);
  CHECK(std::fabs(norm(position(world, bead)) - 1.0) < 1e-6);  // of the spline
  CHECK(world.constraints[path].enabled);
}

TEST_CASE("a bead on a wire with ends slides along and stops at the end") {
  World world;
  const PointId bead = mass_at(world, zero3());
  const auto wire =
      std::make_shared<const Path>(std::vector<Vec3>{zero3(), vec(1, -1, 0), vec(2, -2, 0)}, false, false);
  const ConstraintId path = add_on_path(world, bead, wire);
  advance(world, 0.5);
  CHECK(norm(position(world, bead) - vec(1, -1, 0) * (0.25 * g * 0.25)) < 1e-10);
  advance(world, 2.0);
  CHECK(norm(position(world, bead) - vec(2, -2, 0)) < 1e-10);
  CHECK(std::fabs(world.constraints[path].as<PathData>().along - 2.0) < 1e-10);
  CHECK(norm(velocity(world, bead)) < 1e-9);
  CHECK(norm(world.constraints[path].force - vec(0, g, 0)) < 1e-7);
  CHECK(world.worst.energy < 1e-9);
  CHECK(world.worst.constraint < 1e-10);
}

TEST_CASE("two masses on a string over two positions move as Atwood found") {
  World world;
  const double m1 = 3.0, m2 = 2.0;
  const PointId left = mass_at(world, vec(-1, -2, 0), m1), right = mass_at(world, vec(1, -2, 0), m2);
  const ConstraintId string =
      add_string(world, {through(left), place(vec(-1, 0, 0)), place(vec(1, 0, 0)), through(right)});
  CHECK(world.constraints[string].number.now == 6.0);
  advance(world, 1.0);
  const double a = g * (m1 - m2) / (m1 + m2);
  CHECK(norm(position(world, left) - vec(-1, -2 - 0.5 * a, 0)) < 1e-9);
  CHECK(norm(position(world, right) - vec(1, -2 + 0.5 * a, 0)) < 1e-9);
  CHECK(std::fabs(world.constraints[string].tension - 2 * m1 * m2 * g / (m1 + m2)) < 1e-9);
  CHECK(world.worst.constraint < 1e-10);
  CHECK(world.worst.energy < 1e-9);
}

TEST_CASE(
    "a string slides through a hanging pulley with one tension, and "
    "keeps energy") {
  World world;
  const PointId pulley = mass_at(world, vec(-0.3, -1, 0), 1.0), free_end = mass_at(world, vec(2, -0.5, 0.2), 0.8);
  const ConstraintId string =
      add_string(world, {place(vec(-1, 0, 0)), through(pulley), place(vec(1, 0, 0)), through(free_end)});
  double longest = 0;
  for (int i = 0; i < 480; i++) {
    step(world);
    longest = std::fmax(longest, present_value(world, world.constraints[string]));
  }
  CHECK(world.failure.empty());
  CHECK(longest <= world.constraints[string].number.now * (1 + 1e-10));
  CHECK(world.stats.fallback_steps == 0);
  INFO(world.worst.energy << " halved " << world.stats.halved_steps);
  CHECK(world.worst.energy < 1e-9);
}

TEST_CASE("a string is slack until it is taut, and what it stops it stops for good") {
  World world;
  const PointId stone = mass_at(world, vec(0, -0.5, 0));
  StringDef def;
  def.length = 1.0;
  const ConstraintId string = add_string(world, {place(zero3()), through(stone)}, def);
  advance(world, 0.2);
  CHECK(world.constraints[string].tension == 0.0);
  CHECK(std::fabs(position(world, stone)[1] + 0.5 + 0.5 * g * 0.04) < 1e-12);
  advance(world, 1.0);
  CHECK(norm(position(world, stone) - vec(0, -1, 0)) < 1e-10);
  CHECK(std::fabs(world.constraints[string].tension - g) < 1e-6);
  CHECK(world.worst.energy < 1e-9);
  set_velocity(world, stone, vec(0, 3, 0));
  step(world);
  CHECK(std::fabs(velocity(world, stone)[1] - 3 + g * world.settings.step) < 1e-9);
}

TEST_CASE("a limit of length keeps a distance in its range") {
  World world;
  const PointId a = mass_at(world, vec(0, -0.5, 0));
  const ConstraintId limit = add_limit(world, a, zero3(), {0.2, 1.0, 0.1});
  set_velocity(world, a, vec(0.4, 6, 0));
  double least = 1, most = 0;
  for (int i = 0; i < 480; i++) {
    step(world);
    const double distance = norm(position(world, a));
    least = std::fmin(least, distance);
    most = std::fmax(most, distance);
  }
  CHECK(least > 0.2 - 1e-10);
  CHECK(most < 1.0 + 1e-10);
  CHECK(world.worst.energy < 1e-3);
  CHECK(world.constraints[limit].enabled);
}

TEST_CASE(
    "points far from their plane, path or string's length approach "
    "critically damped") {
  World world;
  world.settings.gravity = zero3();
  const double tau = 0.15;
  StringDef def;
  def.length = 1.0;
  def.time_constant = tau;
  const PointId a = mass_at(world, zero3()), b = mass_at(world, vec(0, 2, 0)), c = mass_at(world, vec(3, 0, 0));
  cases::add_on_plane(world, a, vec(0, 1, 0), vec(0, -2, 0), tau);
  const auto line = std::make_shared<const Path>(std::vector<Vec3>{vec(-9, 0, 0), vec(9, 0, 0)}, false, false);
  add_on_path(world, b, line, tau);
  add_string(world, {through(c), place(zero3())}, def);
  for (int i = 0; i < 240; i++) {
    step(world);
    const double s = world.time / tau, wanted = 2.0 * (1 + s) * std::exp(-s);
    REQUIRE(std::fabs(position(world, a)[1] + 2 - wanted) < 0.01 * wanted + 1e-9);
    REQUIRE(std::fabs(position(world, b)[1] - wanted) < 0.01 * wanted + 1e-9);
  }
  CHECK(world.worst.constraint < 1e-10);
}

TEST_CASE("guide_constraints: the nearest position is found as soon at a corner of a path as beside it") {
  const Path path({zero3(), vec(1, 0, 0), vec(0.5, 1, 0)}, false, true);
  const auto seconds = [&](Vec3 to, double from) {
    double least = infinity, sum = 0.0;
    for (int round = 0; round < 5; round++) {
      const auto start = std::chrono::steady_clock::now();
      for (int i = 0; i < 20'000; i++) sum += path.nearest(to, from);
      least = std::fmin(least, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    CHECK(std::isfinite(sum));
    return least;
  };
  CHECK(seconds(vec(1.2, -0.1, 0), 0.7) < 8.0 * seconds(vec(0.5, -0.1, 0), 0.3));
}

TEST_CASE("guides say what is wrong with what they are given") {
  World world;
  const PointId a = mass_at(world, zero3()), b = mass_at(world, vec(1, 0, 0));
  CHECK_THROWS_WITH(Path({zero3()}, false, false), Contains("a path needs two positions or more, got 1"));
  CHECK_THROWS_WITH(Path({zero3(), zero3()}, false, false), Contains("positions 1 and 2 of the path are the same"));
  CHECK_THROWS_WITH(add_string(world, {through(a)}), Contains("needs two points or more, got 1"));
  StringDef def;
  def.length = 1.0;
  CHECK_THROWS_WITH(add_string(world, {through(a), place(vec(0, 1, 0)), place(vec(0, 3, 0))}, def),
                    Contains("its positions are 2 m apart, so it cannot be 1 m long"));
  CHECK_THROWS_WITH(add_string(world, {place(zero3()), place(vec(0, 1, 0))}), Contains("positions only"));
  CHECK_THROWS_WITH(add_limit(world, a, b, {2.0, 1.0, 0.1}), Contains("min must be below max, got 2 and 1 m"));
  CHECK_THROWS_WITH(cases::add_on_plane(world, a, zero3()), Contains("normal must not be"));
  CHECK(world.constraints.empty());
}
