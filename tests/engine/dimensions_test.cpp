// The length of an articulate, of which all its tolerances are multiples.
#include <catch2/catch.hpp>
#include <cmath>
#include <memory>

#include "edit/constrain.hpp"
#include "laws/library.hpp"
#include "step/step.hpp"
#include "support/cases.hpp"

using namespace pantin;

namespace {

PointId mass_at(World& world, Vec3 at) {
  ParticleDef def;
  def.at = at;
  return cases::point_of(world, add_particle(world, def));
}

/// Where a particle that another holds by a limit is after a second on a spring, in units of `length` [m].
Vec3 orbit(double length) {
  World world;
  world.settings.gravity = zero3();
  const PointId a = mass_at(world, length * vec(1, -1, 0));
  ConnectionDef spring;
  spring.ends = {{world.points[a].particle}, {{}, length * vec(0, 2, 0)}};
  LawArguments arguments;
  arguments.numbers = {{"stiffness", 10.0}, {"length", 0.0}};
  add_connection(world, std::make_shared<const Law>(make_library_law("spring", arguments)[0]), spring);
  add_limit(world, a, mass_at(world, length * vec(2, -1, 0)), {0.5 * length, 1.2 * length, 0.1});
  advance(world, 1.0);
  return position(world, a) / length;
}

/// Where the rim of a body is that was nailed at its centre and tumbled for two seconds, in units of its radius [m].
Vec3 rim_of_tumbling(double radius) {
  World world;
  world.settings.gravity = zero3();
  BodyDef def;
  def.mass = 1.0;
  def.inertia = diagonal(radius * radius * vec(1, 1.5, 2));
  def.points.resize(2);
  def.points[1].at = radius * vec(1, 0, 0);
  def.spin = vec(0, 0.5, 3);
  const BodyId body = add_body(world, def);
  const auto points = world.bodies[body].points;
  add_nail(world, points[0]);
  advance(world, 2.0);
  REQUIRE(world.stats.fallback_steps == 0);
  return position(world, points[1]) / radius;
}

}  // namespace

TEST_CASE("dimensions: particles within limits of their distance move alike at the scale of atoms and of planets") {
  const double length = GENERATE(1e-10, 1e-5, 1e7, 1e12);
  CAPTURE(length);
  const Vec3 at = orbit(length), usual = orbit(1.0);
  REQUIRE(norm(usual - vec(1, -1, 0)) > 0.1);
  CHECK(norm(at - usual) < 1e-7);
}

TEST_CASE("dimensions: a particle that a plane alone holds swings on a spring as the cosine at any scale") {
  const double length = GENERATE(1e-12, 1e-9, 1.0, 1e6, 1e12);
  const bool at_origin = GENERATE(true, false), thrown = GENERATE(true, false);
  CAPTURE(length, at_origin, thrown);
  World world;
  world.settings.gravity = zero3();
  world.settings.step = 1.0 / 960.0;
  ParticleDef def;
  def.at = at_origin ? zero3() : length * vec(1, 1, 1);
  if (thrown) def.velocity = 10.0 * length * vec(1, 0, -1);
  const ParticleId particle = add_particle(world, def);
  cases::add_on_plane(world, cases::point_of(world, particle), vec(1, 1, 1));
  ConnectionDef spring;
  spring.ends = {{particle}, {{}, thrown ? def.at : def.at + length * vec(-1, 0, 1)}};
  LawArguments arguments;
  arguments.numbers = {{"stiffness", 100.0}, {"length", 0.0}};
  add_connection(world, std::make_shared<const Law>(make_library_law("spring", arguments)[0]), spring);
  advance(world, 1.0);
  const Vec3 swing = thrown ? std::sin(10.0) * vec(1, 0, -1) : (1.0 - std::cos(10.0)) * vec(-1, 0, 1);
  CHECK(norm(position(world, particle) - def.at - length * swing) < 1e-4 * length);
  CHECK(world.stats.fallback_steps == 0);
}

TEST_CASE(
    "dimensions: a particle on a plane that begins beside the origin by round-off moves as one that begins there") {
  World world;
  ParticleDef def;
  def.at = 1e-13 * vec(1, -1, 0);
  const ParticleId particle = add_particle(world, def);
  cases::add_on_plane(world, cases::point_of(world, particle), vec(1, 1, 0));
  advance(world, 1.0);
  const double g = norm(world.settings.gravity);
  CHECK(norm(position(world, particle) - 0.25 * g * vec(1, -1, 0)) < 1e-12);
  CHECK(world.stats.fallback_steps == 0);
}

TEST_CASE("dimensions: a particle on a plane that drifts slowly goes on, however far it is from the origin") {
  const double x = GENERATE(0.0, 1.0, 1e3);
  CAPTURE(x);
  World world;
  world.settings.gravity = zero3();
  ParticleDef def;
  def.at = vec(x, 0, 0);
  def.velocity = vec(1e-6, 0, 0);
  const ParticleId particle = add_particle(world, def);
  cases::add_on_plane(world, cases::point_of(world, particle), vec(0, 1, 0));
  advance(world, 10.0);
  CHECK(std::fabs(position(world, particle)[0] - x - 1e-5) < 1e-9);
}

TEST_CASE("dimensions: a body nailed at its centre tumbles alike at the scale of atoms and of planets") {
  const double length = GENERATE(1e-10, 1e-3, 1e10);
  CAPTURE(length);
  const Vec3 at = rim_of_tumbling(length), usual = rim_of_tumbling(1.0);
  REQUIRE(norm(usual - vec(1, 0, 0)) > 0.1);
  CHECK(norm(at - usual) < 1e-9);
}
