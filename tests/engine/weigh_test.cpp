// Bodies with less than six degrees of freedom: lines, single points, free particles in hinges, anchors off the masses.
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "measure/measure.hpp"
#include "step/step.hpp"
#include "support/cases.hpp"
#include "support/watch.hpp"

using namespace pantin;

namespace {

/// A rod of two point masses of 0.5 kg, 1 m apart.
BodyId add_two_masses(World& world, Vec3 at) {
  PointDef head, tail;
  head.at = vec(-0.5, 0, 0);
  tail.at = vec(0.5, 0, 0);
  head.mass = tail.mass = 0.5;
  BodyDef def;
  def.points = {head, tail};
  def.at = at;
  return add_body(world, def);
}

/// A rod of 1 kg with anchors 1 m apart, and `along` [kg m²] for its inertia about its axis, that turns about its head.
BodyId add_rod_with(World& world, Vec3 at, double along, Vec3 spin) {
  PointDef head, tail;
  head.at = vec(-0.5, 0, 0);
  tail.at = vec(0.5, 0, 0);
  BodyDef def;
  def.points = {head, tail};
  def.at = at;
  def.mass = 1.0;
  def.inertia = diagonal(vec(along, 0.25, 0.25));
  def.spin = spin;
  def.velocity = cross(spin, vec(0.5, 0, 0));
  return add_body(world, def);
}

/// Place of the end of `links` such rods hanging on a nail, after each step up to `time` [s], let go from horizontal; with
/// `sideways` the first turns about the vertical too.
std::vector<Vec3> motion_of_end(int links, double along, double time, bool sideways = false) {
  World world;
  std::vector<BodyId> rods;
  for (int i = 0; i < links; i++) {
    rods.push_back(add_rod_with(world, vec(i + 0.5, 0, 0), along, sideways ? vec(0, 2, 0) : zero3()));
    const std::size_t k = rods.size() - 1;
    if (i == 0)
      add_nail(world, cases::point_of(world, rods[k], 0));
    else
      add_hinge(world, std::vector{cases::point_of(world, rods[k - 1], 1), cases::point_of(world, rods[k], 0)});
  }
  const PointId end = cases::point_of(world, rods.back(), 1);
  std::vector<Vec3> positions;
  const Watched course = watch(world, time, [&] { positions.push_back(position(world, end)); });
  CHECK(course.failure == "");
  CHECK(course.finite);
  CHECK(course.gap <= 1e-10);
  CHECK(course.energy_error() <= 1e-9);
  return positions;
}

double largest_difference(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  REQUIRE(a.size() == b.size());
  double difference = 0.0;
  for (std::size_t i = 0; i < a.size(); i++) difference = std::fmax(difference, norm(a[i] - b[i]));
  return difference;
}

}  // namespace

TEST_CASE("rods: inertia about the axis of one rod on a nail is not seen") {
  const std::vector<Vec3> line = motion_of_end(1, 0.0, 5.0);
  const double along = GENERATE(1e-12, 1e-6, 1e-3, 0.05, 0.25);
  CAPTURE(along);
  CHECK(largest_difference(line, motion_of_end(1, along, 5.0)) <= 1e-9);
}

TEST_CASE("rods: nor is it when the rod turns about the vertical") {
  const std::vector<Vec3> line = motion_of_end(1, 0.0, 5.0, true);
  const double along = GENERATE(1e-12, 1e-6, 1e-3, 0.05, 0.25);
  CAPTURE(along);
  CHECK(largest_difference(line, motion_of_end(1, along, 5.0, true)) <= 1e-9);
}

TEST_CASE("rods: inertia about the axes of three rods in a chain is not seen") {
  const std::vector<Vec3> line = motion_of_end(3, 0.0, 1.0);
  const double along = GENERATE(1e-12, 1e-6, 1e-3, 0.05, 0.25);
  CAPTURE(along);
  CHECK(largest_difference(line, motion_of_end(3, along, 1.0)) <= 1e-9);
}

TEST_CASE("rods: two point masses get no spin about their line") {
  const double step_length = GENERATE(1.0 / 60, 1.0 / 240);
  CAPTURE(step_length);
  World world;
  world.settings.step = step_length;
  std::vector<BodyId> rods;
  for (int i = 0; i < 5; i++) {
    rods.push_back(add_two_masses(world, vec(i + 0.5, 0, 0)));
    const std::size_t k = rods.size() - 1;
    if (i > 0)
      add_hinge(world, std::vector{cases::point_of(world, rods[k - 1], 1), cases::point_of(world, rods[k], 0)});
  }
  add_nail(world, cases::point_of(world, rods[0], 0));
  kick(world, cases::point_of(world, rods[4], 1), vec(0, 0, 2));
  step(world);  // the hinges answer the kick
  double spin = 0.0;
  const Watched course = watch(world, 5.0, [&] {
    for (const BodyId rod : rods) {
      const Vec3 axis =
          position(world, cases::point_of(world, rod, 1)) - position(world, cases::point_of(world, rod, 0));
      spin = std::fmax(spin, std::fabs(dot(angular_velocity(world.motion_of(rod)), axis)));
    }
  });
  CHECK(world.motion_of(rods[0]).freedom == Freedom::line);
  CHECK(course.failure == "");
  CHECK(course.finite);
  CHECK(course.gap <= 1e-10);
  CHECK(course.energy_error() <= 1e-9);
  CHECK(spin <= 1e-9);
}

TEST_CASE("rods: a body of one point is a mass on a hinge") {
  World world;
  const cases::Chain chain = cases::add_chain(world, {.links = 3});
  PointDef mass;
  mass.mass = 5.0;
  BodyDef def;
  def.points = {mass};
  def.at = vec(3, 0, 0);
  const BodyId bob = add_body(world, def);
  add_hinge(world, std::vector{chain.tails.back(), cases::point_of(world, bob, 0)});
  CHECK(world.motion_of(bob).freedom == Freedom::point);
  const Watched course = watch(world, 5.0);
  CHECK(course.failure == "");
  CHECK(course.finite);
  CHECK(course.gap <= 1e-10);
  CHECK(course.energy_error() <= 1e-9);
  CHECK(norm(angular_velocity(world.motion_of(bob))) == 0.0);
}

TEST_CASE("rods: a free particle in a hinge moves as a body of one point does") {
  World with_particle, with_body;
  std::vector<Vec3> first, second;
  for (World* world : {&with_particle, &with_body}) {
    const cases::Chain chain = cases::add_chain(*world, {.links = 3});
    PointId bob;
    if (world == &with_particle) {
      ParticleDef def;
      def.at = vec(1, 0, 0);
      def.mass = 5.0;
      bob = cases::point_of(*world, add_particle(*world, def));
    } else {
      PointDef mass;
      mass.mass = 5.0;
      BodyDef def;
      def.points = {mass};
      def.at = vec(1, 0, 0);
      bob = cases::point_of(*world, add_body(*world, def), 0);
    }
    add_hinge(*world, std::vector{chain.tails[0], bob});
    std::vector<Vec3>& positions = world == &with_particle ? first : second;
    const Watched course = watch(*world, 2.0, [&] { positions.push_back(position(*world, chain.tails.back())); });
    CHECK(course.failure == "");
    CHECK(course.gap <= 1e-10);
    CHECK(course.energy_error() <= 1e-9);
  }
  CHECK(largest_difference(first, second) <= 1e-9);
}

TEST_CASE("rods: free particles alone may be a hinge, and fall as one") {
  World world;
  ParticleDef def;
  def.velocity = vec(1, 0, 0);
  const PointId a = cases::point_of(world, add_particle(world, def));
  def.velocity = vec(0, 0, 0);
  def.mass = 3.0;
  const PointId b = cases::point_of(world, add_particle(world, def));
  add_hinge(world, std::vector{a, b});
  const Watched course = watch(world, 1.0);
  CHECK(course.failure == "");
  CHECK(course.gap <= 1e-10);
  CHECK(norm(position(world, a) - vec(0.25, -0.5 * 9.81, 0)) <= 1e-3);
  CHECK(norm(velocity(world, b) - vec(0.25, -9.81, 0)) <= 1e-10);
}

TEST_CASE("rods: a particle on one rod swings as a pendulum") {
  World world;
  ParticleDef def;
  def.at = vec(1, 0, 0);
  const PointId bob = cases::point_of(world, add_particle(world, def));
  const ConstraintId rod = add_rod(world, bob, zero3());
  double lowest = 0.0, tension = 0.0;
  const Watched course = watch(world, 5.0, [&] {
    lowest = std::fmin(lowest, position(world, bob)[1]);
    tension = std::fmax(tension, world.constraints[rod].tension);
  });
  CHECK(course.failure == "");
  CHECK(course.energy_error() <= 1e-9);
  CHECK(world.worst.constraint <= 1e-10);
  CHECK(lowest == Approx(-1.0).margin(1e-3));
  CHECK(tension == Approx(3 * 9.81).epsilon(1e-3));
}

TEST_CASE("rods: an anchor off the line of the masses is held up by a lifted inertia") {
  World world;
  PointDef left, right, anchor;
  left.at = vec(-0.5, 0, 0);
  right.at = vec(0.5, 0, 0);
  left.mass = right.mass = 1.0;
  anchor.at = vec(0, 0.5, 0);
  BodyDef def;
  def.points = {left, right, anchor};
  def.name = "hanger";
  const BodyId hanger = add_body(world, def);
  add_nail(world, cases::point_of(world, hanger, 2));
  CHECK(lift(world, hanger) > 0.0);
  CHECK(world.motion_of(hanger).inertia[0] == Approx(1e-4 * 0.5));
  kick(world, hanger, vec(0.3, 0, 1));
  step(world);  // the nail answers the kick
  const Watched course = watch(world, 5.0);
  CHECK(course.failure == "");
  CHECK(course.finite);
  CHECK(course.gap <= 1e-10);
  CHECK(course.energy_error() <= 1e-9);
}

TEST_CASE("rods: one mass with an anchor elsewhere is an error that says what to use") {
  World world;
  PointDef mass, anchor;
  mass.mass = 1.0;
  anchor.at = vec(1, 0, 0);
  BodyDef def;
  def.points = {mass, anchor};
  CHECK_THROWS_WITH(add_body(world, def), Catch::Contains("rod") || Catch::Contains("inertia"));
  CHECK(world.bodies.empty());
  CHECK(world.points.empty());
}
