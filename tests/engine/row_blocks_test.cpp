// Bodies of so many rows that these meet at variables of the body.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "articulates/articulate.hpp"
#include "edit/constrain.hpp"
#include "measure/measure.hpp"
#include "step/step.hpp"
#include "support/cases.hpp"
#include "support/watch.hpp"

using namespace pantin;

namespace {

std::size_t hubs(const World& world) {
  std::size_t count = 0;
  for (const auto& articulate : world.articulates) count += articulate->hubs.size();
  return count;
}

void check_exact(World& world, double time, double gap = 1e-10) {
  const Watched course = watch(world, world.time + time);
  CHECK(course.failure == "");
  CHECK(course.finite);
  CHECK(course.gap <= gap);
  CHECK(world.stats.fallback_steps == 0);
}

}  // namespace

TEST_CASE("hub: a body of 500 hinges keeps its gaps closed and its energy") {
  World world;
  const cases::Wheel wheel = cases::add_wheel(world, {.spokes = 500});
  kick(world, wheel.hub, vec(30, 0, 20), vec(1, 0, 0));
  step(world);  // the spokes take up the kick
  const Watched course = watch(world, 1.0);
  CHECK(course.failure == "");
  CHECK(course.gap <= 1e-8);
  CHECK(course.energy_error() <= 1e-9);
  CHECK(hubs(world) == 1);
  CHECK(world.stats.fallback_steps == 0);
}

TEST_CASE("hub: it is one from nine rows on") {
  World small, large;
  cases::add_wheel(small, {.spokes = 8});
  cases::add_wheel(large, {.spokes = 9});
  step(small);
  step(large);
  CHECK(hubs(small) == 0);
  CHECK(hubs(large) == 1);
}

// The same disc as two that are welded at their centre, each with half of the spokes, which no hub helps to solve.
TEST_CASE("hub: it moves as two halves do that are welded together") {
  World whole, halves;
  const cases::Wheel one = cases::add_wheel(whole, {.spokes = 14});
  const cases::Wheel left = cases::add_wheel(halves, {.spokes = 14, .from = 0, .to = 7, .mass = 50}),
                     right = cases::add_wheel(halves, {.spokes = 14, .from = 7, .to = 14, .mass = 50});
  add_weld(halves, left.hub, right.hub);
  for (World* world : {&whole, &halves}) world->settings.energy_return = false;
  kick(whole, one.hub, vec(30, 0, 20), vec(1, 0, 0));
  kick(halves, left.hub, vec(15, 0, 10), vec(1, 0, 0));
  kick(halves, right.hub, vec(15, 0, 10), vec(1, 0, 0));
  advance(whole, 0.5);
  advance(halves, 0.5);
  CHECK(hubs(whole) == 1);
  CHECK(hubs(halves) == 0);
  CHECK(norm(position(whole, one.edge[5]) - position(halves, left.edge[5])) <= 1e-6);
  CHECK(norm(position(whole, one.edge[10]) - position(halves, right.edge[3])) <= 1e-6);
  CHECK(norm(position(whole, one.ends[10]) - position(halves, right.ends[3])) <= 1e-6);
}

TEST_CASE("hub: pinned at its centre it is solved as fast as free") {
  World world;
  const cases::Wheel wheel = cases::add_wheel(world, {.spokes = 40});
  add_nail(world, wheel.centre);
  kick(world, wheel.hub, vec(30, 0, 20), vec(1, 0, 0));
  check_exact(world, 1.0);
  CHECK(world.stats.newton_iterations <= 3 * world.steps);
  CHECK(hubs(world) == 1);
}

TEST_CASE("hub: hung by forty parallel rods, of which three would do, it swings") {
  World world;
  BodyDef plate;
  plate.mass = 100;
  plate.inertia = diagonal(vec(25, 50, 25));
  for (int i = 0; i < 40; i++) {
    const double angle = 2.0 * std::numbers::pi * i / 40;
    PointDef point;
    point.at = vec(std::cos(angle), 0, std::sin(angle));
    plate.points.push_back(point);
  }
  const BodyId hub = add_body(world, plate);
  for (std::size_t i = 0; i < 40; i++) {
    const PointId point = cases::point_of(world, hub, i);
    BodyDef rod;
    rod.at = position(world, point) + vec(0, 0.5, 0);
    rod.orientation = Quat{std::sqrt(0.5), 0, 0, std::sqrt(0.5)};
    const BodyId body = cases::add_rod_body(world, 1, 1, rod);
    add_hinge(world, std::vector{point, cases::point_of(world, body, 0)});
    add_nail(world, cases::point_of(world, body, 1));
  }
  kick(world, hub, vec(60, 0, 0));
  check_exact(world, 1.0);
  CHECK(hubs(world) == 1);
  CHECK(norm(cross(rotate(orientation(world, hub), vec(0, 1, 0)), vec(0, 1, 0))) <= 1e-7);
}

TEST_CASE("hub: of twelve rods in one ring the one at which it is pulled is a hub") {
  World world;
  world.settings.gravity = zero3();
  std::vector<PointId> points;
  for (int i = 0; i < 12; i++) {
    const double half = std::numbers::pi * i / 12;
    BodyDef rod;
    rod.at = vec(std::cos(2.0 * half), std::sin(2.0 * half), 0) * 0.5;
    rod.orientation = Quat{std::cos(half), 0, 0, std::sin(half)};
    points.push_back(cases::point_of(world, cases::add_rod_body(world, 1, 1, rod), 0));
  }
  add_hinge(world, points);
  for (const PointId point : points) kick(world, world.points[point].body, vec(0, 0.1 * point.slot, 1.0));
  step(world);
  const double before = energy(world).kinetic;
  check_exact(world, 0.5);
  CHECK(hubs(world) == 1);
  CHECK(energy(world).kinetic == Approx(before).epsilon(1e-9));
}

TEST_CASE("hub: rows of all kinds on it hold") {
  World world;
  const cases::Wheel wheel = cases::add_wheel(world, {.spokes = 20, .links = 1});
  const auto rod_at = [&](Vec3 head) {
    BodyDef rod;
    rod.at = head + vec(0.5, 0, 0);
    return cases::add_rod_body(world, 1, 1, rod);
  };
  const auto centre = [&](BodyId body) { return world.motion_of(body).x; };
  const BodyId welded = rod_at(vec(0, 1, 0)), driven = rod_at(vec(0, -1, 0)), held = rod_at(vec(0, 2, 3));
  const ConstraintId rod = add_rod(world, wheel.edge[0], vec(1, 4, 0));
  add_rod(world, wheel.edge[5], cases::point_of(world, held, 0));
  add_weld(world, wheel.hub, welded);
  MotorDef drive;
  drive.axis = vec(0, 1, 0);
  drive.speed = 2.0;
  const ConstraintId motor = add_motor(world, driven, wheel.hub, drive);
  add_limit(world, wheel.edge[10], vec(-1, 3, 0), {.max = 3.2});
  const ConstraintId plane = cases::add_on_plane(world, wheel.centre, vec(1, 0, 0));
  FollowDef follow;
  follow.at = vec(0, 1, 0);
  follow.max_force = 500;
  add_follow(world, wheel.centre, follow);
  const double length = norm(position(world, wheel.edge[5]) - position(world, cases::point_of(world, held, 0)));
  const Vec3 apart = centre(welded) - position(world, wheel.centre);
  check_exact(world, 0.5);
  CHECK(hubs(world) == 1);
  CHECK(norm(position(world, wheel.edge[0]) - vec(1, 4, 0)) == Approx(world.constraints[rod].number.now).epsilon(1e-9));
  CHECK(norm(position(world, wheel.edge[5]) - position(world, cases::point_of(world, held, 0))) ==
        Approx(length).epsilon(1e-9));
  CHECK(norm(centre(welded) - position(world, wheel.centre)) == Approx(norm(apart)).epsilon(1e-9));
  CHECK(world.constraints[motor].angle == Approx(1.0).epsilon(1e-4));
  CHECK(std::fabs(position(world, wheel.centre)[0]) <= 1e-9);
  CHECK(norm(world.constraints[plane].force) > 0.0);
}

TEST_CASE("hub: a body nailed at twenty positions is none, and rests") {
  World world;
  BodyDef plate;
  plate.mass = 100;
  plate.inertia = diagonal(vec(25, 50, 25));
  for (int i = 0; i < 20; i++) {
    PointDef point;
    point.at = vec(0.1 * i, 0, 0.01 * i * i);
    plate.points.push_back(point);
  }
  const BodyId body = add_body(world, plate);
  for (const PointId point : world.bodies[body].points) add_nail(world, point);
  check_exact(world, 0.5);
  CHECK(hubs(world) == 0);
  CHECK(norm(world.motion_of(body).x) <= 1e-12);
}

TEST_CASE("hub: with a string on it, it is no hub, and holds") {
  World world;
  const cases::Wheel wheel = cases::add_wheel(world, {.spokes = 20, .links = 1});
  add_string(world, {{{}, vec(0, 3, 0)}, {wheel.centre, zero3()}});
  check_exact(world, 0.5);
  CHECK(hubs(world) == 0);
}

TEST_CASE("hub: particles with many springs that are solved are, and go where springs that kick take them") {
  World solved, kicked;
  for (World* world : {&solved, &kicked}) {
    const auto cube = cases::add_cube(*world, {.solve = world == &solved ? Solve::at_middle : Solve::explicitly});
    set_velocity(*world, cases::point_of(*world, cube.front()), vec(2, 1, 0));
    world->settings.step = 1.0 / 2000;
    const Watched course = watch(*world, 0.1);
    CHECK(course.failure == "");
  }
  CHECK(hubs(solved) == 117);
  CHECK(hubs(kicked) == 0);
  for (const ParticleId particle : solved.particles.ids())
    CHECK(norm(position(solved, particle) - position(kicked, particle)) <= 1e-5);
}

TEST_CASE("hub: the matrix of a lattice of springs is that of its particles, not of its springs") {
  World world;
  cases::add_cube(world, {.stiffness = 1e6});
  check_exact(world, 0.1);
  REQUIRE(world.articulates.size() == 1);
  CHECK(world.articulates[0]->rows.size() == 1036);
  CHECK(world.articulates[0]->factor.below.size() <= 20'000);
}
