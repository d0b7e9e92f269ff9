#include "edit/edit.hpp"

#include <catch2/catch.hpp>

#include "measure/measure.hpp"
#include "step/step.hpp"
#include "support/rods.hpp"

using namespace pantin;
using namespace pantin::test;
using Catch::Contains;

namespace {
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
}

TEST_CASE("a particle is made with what was given") {
  World world;
  ParticleDef def;
  def.at = vec(1, 2, 3);
  def.velocity = vec(4, 5, 6);
  def.mass = 2;
  def.name = "ball";
  def.lifetime = 3;
  const ParticleId id = add_particle(world, def);
  const Point& p = world.points[point_of(world, id)];
  CHECK(same(position(world, id), def.at));
  CHECK(same(velocity(world, id), def.velocity));
  CHECK(p.mass == 2.0);
  CHECK(p.own == id);
  CHECK(world.particles[id].name == "ball");
  REQUIRE(world.mortals.size() == 1);
  CHECK(world.mortals[0].particle == id);
}

TEST_CASE("bad numbers of a particle are named with their unit, and nothing is made") {
  World world;
  ParticleDef def;
  def.mass = 0;
  CHECK_THROWS_WITH(add_particle(world, def), "particle: mass must be > 0 kg and finite, got 0");
  def = {};
  def.at = vec(0, not_a_number, 0);
  CHECK_THROWS_WITH(add_particle(world, def), "particle: at must be finite, got (0, NaN, 0) m");
  def = {};
  def.velocity = vec(infinity, 0, 0);
  CHECK_THROWS_WITH(add_particle(world, def), Contains("velocity") && Contains("m/s"));
  def = {};
  def.radius = -1;
  CHECK_THROWS_WITH(add_particle(world, def), Contains("radius must be >= 0 m"));
  def = {};
  def.lifetime = not_a_number;
  CHECK_THROWS_WITH(add_particle(world, def), Contains("lifetime must be > 0 s"));
  CHECK(world.particles.empty());
}

TEST_CASE("bad numbers of a body are named, and nothing is made") {
  World world;
  BodyDef def = rod_at(zero3());
  def.points[1].mass = -1;
  CHECK_THROWS_WITH(add_body(world, def), "body: point 2: mass must be >= 0 kg and finite, got -1");
  def = rod_at(zero3(), "arm");
  def.points[0].name = def.points[1].name = "tip";
  CHECK_THROWS_WITH(add_body(world, def), "body 'arm': two points have the name 'tip'");
  def = rod_at(zero3());
  def.orientation = {0, 0, 0, 0};
  CHECK_THROWS_WITH(add_body(world, def), Contains("orientation"));
  def = rod_at(zero3());
  def.spin = vec(0, 0, not_a_number);
  CHECK_THROWS_WITH(add_body(world, def), Contains("spin") && Contains("rad/s"));
  CHECK(world.bodies.empty());
  CHECK(world.points.empty());
}

TEST_CASE("an inertia that no body has is an error with its values") {
  World world;
  BodyDef def = rod_at(zero3());
  def.mass = 1;
  def.inertia = diagonal(vec(1, 1, 3));
  CHECK_THROWS_WITH(add_body(world, def), Contains("(1, 1, 3) kg m²"));
  def.inertia = diagonal(vec(-1, 1, 1));
  CHECK_THROWS_WITH(add_body(world, def), Contains("negative"));
  def.inertia = diagonal(vec(1, 1, 1));
  def.inertia[0][1] = 0.5;
  CHECK_THROWS_WITH(add_body(world, def), Contains("symmetric"));
  def.inertia = diagonal(vec(1, 1, 2));  // a flat body: just possible
  CHECK_NOTHROW(add_body(world, def));
}

TEST_CASE("a locked world refuses every edit") {
  Two t;
  t.world.locked = true;
  const std::string says = "the world cannot be edited while it steps";
  CHECK_THROWS_WITH(add_particle(t.world, {}), Contains(says));
  CHECK_THROWS_WITH(cut(t.world, t.hinge), Contains(says));
  CHECK_THROWS_WITH(remove(t.world, t.a), Contains(says));
  CHECK_THROWS_WITH(push(t.world, t.a, vec(1, 0, 0)), Contains(says));
  CHECK_THROWS_WITH(set_velocity(t.world, t.a, zero3()), Contains(says));
}

TEST_CASE("a point is added to a moving body without changing its velocities") {
  World world;
  BodyDef def = rod_at(zero3());
  def.velocity = vec(1, 0, 0);
  def.spin = vec(0, 0, 2);
  const BodyId body = add_body(world, def);
  const Vec3 before = velocity(world, left_of(world, body));
  PointDef point;
  point.at = vec(0, 1, 0);
  point.mass = 3;
  point.name = "tip";
  const PointId id = add_point(world, body, point);
  CHECK(world.motion_of(body).mass == 5.0);
  CHECK(norm(velocity(world, left_of(world, body)) - before) < 1e-14);
  CHECK(norm(velocity(world, id) - (before + cross(vec(0, 0, 2), vec(0, 1, 0)))) < 1e-14);
  CHECK_THROWS_WITH(add_point(world, body, point), Contains("the name 'tip' is taken"));
  point.mass = not_a_number;
  CHECK_THROWS_WITH(add_point(world, body, point), Contains("mass must be >= 0 kg"));
}

TEST_CASE("state is set and read back") {
  World world;
  const BodyId body = add_body(world, rod_at(zero3()));
  set_velocity(world, body, vec(1, 2, 3));
  set_spin(world, body, vec(0, 4, 5));
  set_origin(world, body, vec(7, 8, 9));
  CHECK(norm(origin(world, body) - vec(7, 8, 9)) < 1e-14);
  CHECK(norm(angular_velocity(world.motion_of(body)) - vec(0, 4, 5)) < 1e-14);
  const Vec3 centre = world.motion_of(body).x;
  const double s = std::sqrt(0.5);
  set_orientation(world, body, {s, 0, 0, s});
  CHECK(norm(world.motion_of(body).x - centre) == 0.0);
  CHECK(norm(position(world, right_of(world, body)) - centre - vec(0, 0.5, 0)) < 1e-14);
  CHECK(norm(angular_velocity(world.motion_of(body)) - vec(0, 0, 5)) < 1e-14);  // the line of its points is now y
  CHECK_THROWS_WITH(set_position(world, left_of(world, body), zero3()), Contains("moves with its body"));
  CHECK_THROWS_WITH(set_position(world, body, vec(not_a_number, 0, 0)), Contains("must be finite"));
}

TEST_CASE("changing a mass keeps velocities, and a mass that makes no body changes nothing") {
  World world;
  BodyDef def = rod_at(zero3());
  def.velocity = vec(1, 1, 0);
  def.spin = vec(0, 0, 3);
  const BodyId body = add_body(world, def);
  const Vec3 left = velocity(world, left_of(world, body)), right = velocity(world, right_of(world, body));
  set_mass(world, left_of(world, body), 9);
  CHECK(norm(velocity(world, left_of(world, body)) - left) < 1e-14);
  CHECK(norm(velocity(world, right_of(world, body)) - right) < 1e-14);
  CHECK_THROWS_WITH(set_mass(world, left_of(world, body), 0), Contains("no inertia"));
  CHECK(world.points[left_of(world, body)].mass == 9.0);
  CHECK(world.motion_of(body).mass == 10.0);
  const PointId ball = point_of(world, add_particle(world, {}));
  CHECK_THROWS_WITH(set_mass(world, ball, 0), Contains("mass must be > 0 kg"));
}

TEST_CASE("pushes and twists add up; kicks change momentum at once") {
  World world;
  BodyDef def = rod_at(zero3());
  def.mass = 1;
  def.inertia = diagonal(vec(1, 1, 1));
  const BodyId body = add_body(world, def);
  const Vec3 x = world.motion_of(body).x;
  push(world, body, vec(1, 0, 0));
  push(world, body, vec(0, 2, 0), x + vec(3, 0, 0));
  twist(world, body, vec(1, 1, 1));
  CHECK(same(world.motion_of(body).force, vec(1, 2, 0)));
  CHECK(norm(world.motion_of(body).torque - vec(1, 1, 7)) < 1e-14);
  kick(world, body, vec(0, 2, 0), x + vec(3, 0, 0));
  CHECK(same(world.motion_of(body).p, vec(0, 2, 0)));
  CHECK(norm(angular_momentum(world, body) - vec(0, 0, 6)) < 1e-14);
  CHECK_THROWS_WITH(push(world, body, vec(not_a_number, 0, 0)), Contains("push: force must be finite"));
}

TEST_CASE("what cannot turn cannot be twisted") {
  World world;
  const BodyId rod = add_body(world, rod_at(zero3(), "rod"));
  CHECK_NOTHROW(twist(world, rod, vec(0, 1, 2)));
  CHECK_THROWS_WITH(twist(world, rod, vec(1, 1, 0)), Contains("body 'rod' cannot turn about the line"));
  BodyDef def;
  def.mass = 1;
  def.name = "dot";
  const BodyId dot_body = add_body(world, def);
  CHECK_THROWS_WITH(twist(world, dot_body, vec(1, 0, 0)), Contains("body 'dot' cannot turn"));
  push(world, rod, vec(0, 0, 1), vec(0.5, 1, 0));  // an arm off the line: its part about the line turns nothing
  CHECK(world.motion_of(rod).torque[0] == Approx(0.0).margin(1e-15));
}

TEST_CASE("edits count the energy that they make") {
  World world;
  const BodyId body = add_body(world, rod_at(vec(0, 5, 0)));
  const PointId ball = point_of(world, add_particle(world, {}));
  const auto expect_balance = [&](auto edit) {
    const double before = energy(world).total(), work = world.work;
    edit();
    CHECK(world.work - work == Approx(energy(world).total() - before).margin(1e-12));
  };
  expect_balance([&] { set_velocity(world, body, vec(1, 2, 3)); });
  expect_balance([&] { set_spin(world, body, vec(0, 2, 3)); });
  expect_balance([&] { set_position(world, body, vec(1, 9, 3)); });
  expect_balance([&] { set_mass(world, left_of(world, body), 4); });
  expect_balance([&] { set_own_mass(world, body, 2); });
  expect_balance([&] { set_own_inertia(world, body, diagonal(vec(1, 1, 1))); });
  expect_balance([&] { kick(world, body, vec(0, 1, 0), vec(0, 0, 0)); });
  expect_balance([&] { kick(world, ball, vec(0, 1, 0)); });
  expect_balance([&] { set_position(world, ball, vec(0, 1, 0)); });
  expect_balance([&] { set_mass(world, ball, 7); });
  expect_balance([&] { remove_point(world, left_of(world, body)); });
  expect_balance([&] { remove(world, body); });
  expect_balance([&] { remove(world, ball); });
  expect_balance([&] { add_body(world, rod_at(vec(0, 5, 0))); });
  expect_balance([&] { set_gravity(world, vec(1, -2, 3)); });
  CHECK(energy(world).total() != 0.0);
}

TEST_CASE("a group keeps no list of the dead, and its living in their order") {
  World world;
  const GroupId group = add_group(world, "rain"), empty = add_group(world, "empty");
  const auto drop = [&] {
    const ParticleId p = add_particle(world, {});
    add_to_group(world, group, p);
    return p;
  };
  add_to_group(world, group, empty);
  std::vector<AnyId> living = {empty, drop(), drop()};
  for (int i = 0; i < 100'000; i++) {
    if (i % 40'000 == 0) living.push_back(drop());
    remove(world, drop());
  }
  const Group& row = world.groups[group];
  CHECK(row.members.size() <= 64);
  CHECK(row.known.size() == row.members.size());
  std::vector<AnyId> found;
  for (const AnyId& thing : row.members)
    if (thing == AnyId{empty} || alive(world, thing)) found.push_back(thing);
  CHECK(found == living);
  for (const AnyId& thing : living) remove_from_group(world, group, thing);
  CHECK_FALSE(alive(world, group));
}

TEST_CASE("a group holds any living thing once, and never itself") {
  Two t;
  const GroupId group = add_group(t.world, "all"), inner = add_group(t.world, "inner");
  add_to_group(t.world, group, t.a);
  add_to_group(t.world, group, t.a);
  add_to_group(t.world, group, inner);
  CHECK(t.world.groups[group].members.size() == 2);
  CHECK_THROWS_WITH(add_to_group(t.world, inner, group), Contains("a group cannot hold itself"));
  remove_from_group(t.world, group, t.a);
  CHECK_THROWS_WITH(remove_from_group(t.world, group, t.a), Contains("body 'a' is not in it"));
  remove(t.world, t.a);
  CHECK_THROWS_WITH(add_to_group(t.world, group, t.a), Contains("body 'a' was removed"));
  remove(t.world, group);
  CHECK_THROWS_WITH(add_to_group(t.world, group, t.b), Contains("group 'all' was removed"));
  CHECK(t.world.bodies.alive(t.b));
}

TEST_CASE("gravity that is no number is an error") {
  World world;
  CHECK_THROWS_WITH(set_gravity(world, vec(0, not_a_number, 0)), Contains("gravity must be finite"));
  CHECK(same(world.settings.gravity, vec(0, -9.81, 0)));
}

TEST_CASE("a lifetime written again and again is waited for once, and may be taken back") {
  World world;
  const ParticleId id = add_particle(world, {});
  for (int i = 1; i < 100; i++) set_lifetime(world, id, 0.01 * i);
  CHECK(world.mortals.size() == 1);
  set_lifetime(world, id, infinity);
  advance(world, 0.015);
  CHECK(world.particles.alive(id));
  CHECK(world.mortals.empty());
  set_lifetime(world, id, 0.02);
  advance(world, 0.025);
  CHECK_FALSE(world.particles.alive(id));
}

TEST_CASE("the end of the lifetime of a point that its body needs is dropped and logged") {
  World world;
  world.who = [] { return std::string("the test"); };
  const BodyId body = add_body(world, rod_at(zero3(), "rod"));
  for (PointId p : world.bodies[body].points) set_lifetime(world, world.points[p].own, 0.01);
  advance(world, 0.02);
  CHECK(world.bodies[body].points.size() == 1);
  REQUIRE(world.log.size() == 1);
  CHECK(world.log[0].kind == "dropped");
  CHECK_THAT(world.log[0].text, Contains("point 1 of body 'rod'") && Contains("mass must be > 0 kg"));
  CHECK(world.who() == "the test");
}

TEST_CASE("a step's length changes from the present time on") {
  World world;
  world.time = 1.5;
  world.step_count = 360;
  set_step(world, 0.01);
  CHECK(next_time(world) == 1.51);
  CHECK_THROWS_WITH(set_step(world, 0), Contains("step must be > 0 s"));
  CHECK_THROWS_WITH(set_step(world, not_a_number), Contains("step must be > 0 s"));
}

TEST_CASE("an integrator, a plane or a hand that there is not is an error") {
  Two t;
  CHECK_THROWS_WITH(set_integrator(t.world, static_cast<Integrator>(99)), "scene: there is no integrator 99");
  CHECK(t.world.settings.integrator == Integrator::verlet);
  for (const int normal : {99, 3, -2})
    CHECK_THROWS_WITH(set_plane(t.world, Plane{normal}), Contains("its normal must be an axis, 0 to 2"));
  CHECK_FALSE(t.world.plane.flat());
  FollowDef follow;
  follow.hand = -5;
  CHECK_THROWS_WITH(add_follow(t.world, t.world.bodies[t.b].points[1], follow),
                    "follow: hand must be the number of one, or -1 for none, got -5");
  CHECK(t.world.constraints.empty());
}
