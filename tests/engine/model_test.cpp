#include "model/model.hpp"

#include <catch2/catch.hpp>

#include "edit/edit.hpp"
#include "step/step.hpp"

using namespace pantin;
using Catch::Contains;

namespace {

const Quat oblique = normalised({0.3, -0.7, 0.2, 0.5});

BodyDef of_points(std::vector<PointDef> points) {
  BodyDef def;
  def.points = std::move(points);
  return def;
}

PointDef mass_at(Vec3 at, double mass) {
  PointDef p;
  p.at = at;
  p.mass = mass;
  return p;
}

ParticleDef free_mass(double mass) {
  ParticleDef def;
  def.mass = mass;
  return def;
}

double largest_difference(const Mat3& a, const Mat3& b) {
  double d = 0.0;
  for (int i = 0; i < 3; i++) d = std::fmax(d, largest(a[i] - b[i]));
  return d;
}

}  // namespace

TEST_CASE("two point masses turn about their centre with the reduced mass") {
  for (double length : {1.0, 1e-9, 1e6}) {
    CAPTURE(length);
    World world;
    const BodyId id = add_body(world, of_points({mass_at(vec(0, 0, 0), 3), mass_at(vec(0, length, 0), 1)}));
    const Motion& m = world.motion_of(id);
    CHECK(m.mass == 4.0);
    CHECK(norm(m.x - vec(0, length / 4, 0)) < 1e-15 * length);
    CHECK(m.freedom == Freedom::line);
    const double across = 3.0 * 1.0 / 4.0 * length * length;
    for (int i = 0; i < 3; i++) CHECK(m.inertia[i] == Approx(across).epsilon(1e-14));
    CHECK(std::fabs(rotate(m.q, vec(1, 0, 0))[1]) == Approx(1.0));  // the first axis is the line
  }
}

TEST_CASE("an anchor off the line of the masses makes a rigid body with a lifted inertia, which is told") {
  World world;
  const BodyId id =
      add_body(world, of_points({mass_at(vec(-1, 0, 0), 1), mass_at(vec(1, 0, 0), 1), mass_at(vec(0, 0.5, 0), 0)}));
  CHECK(world.motion_of(id).freedom == Freedom::rigid);
  CHECK(lift(world, id) == Approx(2e-4));
  CHECK(world.motion_of(id).inertia[0] == Approx(2e-4));
  CHECK(world.motion_of(id).inertia[2] == Approx(2.0));
  step(world);
  REQUIRE(world.log.size() == 1);
  CHECK(world.log[0].kind == "warning");
  CHECK_THAT(world.log[0].text, Contains("it has points off an axis about which it has no inertia"));
}

TEST_CASE("points in a plane are an ordinary body: the largest moment is the sum of the others") {
  World world;
  const BodyId id =
      add_body(world, of_points({mass_at(vec(0, 0, 0), 1), mass_at(vec(2, 0, 0), 1), mass_at(vec(0, 1, 0), 1)}));
  const Vec3 i = world.motion_of(id).inertia;
  CHECK(i[2] == Approx(static_cast<double>(i[0] + i[1])));
  CHECK(lift(world, id) == 0.0);
}

TEST_CASE("all points at one position are a point mass, wherever that is") {
  for (double far : {0.0, 0.1, 1e6}) {
    World world;
    const Vec3 at = vec(far, 3 * far, -far);
    const BodyId id = add_body(world, of_points({mass_at(at, 0.1), mass_at(at, 0.7), mass_at(at, 0)}));
    CHECK(world.motion_of(id).freedom == Freedom::point);
    CHECK(same(world.motion_of(id).inertia, zero3()));
    CHECK(same(angular_velocity(world.motion_of(id)), zero3()));
  }
}

TEST_CASE("a point with a given inertia turns") {
  World world;
  BodyDef def = of_points({mass_at(zero3(), 0)});
  def.mass = 5;
  def.inertia = diagonal(vec(2, 2, 2));  // a solid sphere of radius 1: 2/5 m r²
  const BodyId id = add_body(world, def);
  CHECK(world.motion_of(id).freedom == Freedom::rigid);
  CHECK(same(world.motion_of(id).inertia, vec(2, 2, 2)));
}

TEST_CASE("given inertia and a point mass add by the parallel axis theorem") {
  World world;
  BodyDef def = of_points({mass_at(vec(3, 0, 0), 1)});
  def.mass = 2;
  def.inertia = diagonal(vec(0.5, 0.6, 0.7));
  def.at = vec(10, 0, 0);
  const BodyId id = add_body(world, def);
  const Motion& m = world.motion_of(id);
  CHECK(norm(m.x - vec(11, 0, 0)) < 1e-14);
  const double reduced = 2.0 * 1.0 / 3.0 * 9.0;
  CHECK(largest_difference(inertia(world, id), diagonal(vec(0.5, 0.6 + reduced, 0.7 + reduced))) < 1e-13);
  CHECK(norm(origin(world, id) - vec(10, 0, 0)) < 1e-14);
}

TEST_CASE("the frame's position and orientation are what was given") {
  World world;
  BodyDef def = of_points({mass_at(vec(1, 0, 0), 1), mass_at(vec(0, 2, 0), 2), mass_at(vec(0, 0, 3), 3)});
  def.at = vec(1, 2, 3);
  def.orientation = {0.6, -1.4, 0.4, 1.0};  // twice a unit quaternion's length is as good
  def.velocity = vec(0.1, 0.2, 0.3);
  def.spin = vec(1, -2, 0.5);
  const BodyId id = add_body(world, def);
  CHECK(norm(origin(world, id) - vec(1, 2, 3)) < 1e-14);
  const Body& body = world.bodies[id];
  for (PointId p : body.points) {
    const Vec3 expected = vec(1, 2, 3) + rotate(oblique, world.points[p].position);
    CHECK(norm(position(world, p) - expected) < 1e-14);
    CHECK(norm(velocity(world, p) - (def.velocity + cross(def.spin, expected - world.motion_of(id).x))) < 1e-14);
  }
  CHECK(norm(angular_velocity(world.motion_of(id)) - def.spin) < 1e-14);
  CHECK(norm(angular_momentum(world, id) - inertia(world, id) * def.spin) < 1e-13);
}

TEST_CASE("a body of no mass is an error, and so is mass at one position with points elsewhere") {
  World world;
  CHECK_THROWS_WITH(add_body(world, of_points({mass_at(zero3(), 0)})), "body: mass must be > 0 kg, got 0");
  CHECK_THROWS_WITH(add_body(world, BodyDef{}), "body: mass must be > 0 kg, got 0");
  CHECK_THROWS_WITH(add_body(world, of_points({mass_at(zero3(), 1), mass_at(vec(1, 0, 0), 0)})),
                    Contains("rod") && Contains("inertia"));
  CHECK(world.bodies.empty());
  CHECK(world.points.empty());
  CHECK(world.particles.empty());
}

TEST_CASE("update_mass keeps the velocity of every point, and leaves a body that it cannot weigh") {
  World world;
  BodyDef def = of_points({mass_at(vec(1, 0, 0), 1), mass_at(vec(0, 2, 0), 2), mass_at(vec(0, 0, 3), 3)});
  def.orientation = oblique;
  def.velocity = vec(1, 2, 3);
  def.spin = vec(0.3, 0.2, -0.9);
  const BodyId id = add_body(world, def);
  const std::vector<PointId> points = world.bodies[id].points;
  std::vector<Vec3> before, positions;
  for (PointId p : points) before.push_back(velocity(world, p)), positions.push_back(position(world, p));

  world.points[points[0]].mass = 50;
  update_mass(world, id);
  CHECK(world.motion_of(id).mass == 55.0);
  for (std::size_t i = 0; i < points.size(); i++) {
    CHECK(norm(velocity(world, points[i]) - before[i]) < 1e-13);
    CHECK(norm(position(world, points[i]) - positions[i]) < 1e-13);
  }
  for (PointId p : points) world.points[p].mass = 0;
  CHECK_THROWS_AS(update_mass(world, id), Error);
  CHECK(world.motion_of(id).mass == 55.0);
}

TEST_CASE("a ring is where its points are, weighs what they weigh, and is pulled at its heaviest body") {
  World world;
  const ParticleId light = add_particle(world, free_mass(1)), heavy = add_particle(world, free_mass(4));
  const PointId points[] = {world.particles[light].points[0], world.particles[heavy].points[0]};
  const ParticleId ring = add_hinge(world, points);
  CHECK(mass(world, ring) == 5.0);
  CHECK(star(world, ring) == points[1]);
  CHECK(awake(world, light) == ring);
  CHECK(awake(world, ring) == ring);
  CHECK(same(position(world, light), position(world, ring)));
}

TEST_CASE("things are called by name, else by number, and the dead by their story") {
  World world;
  BodyDef def = of_points({mass_at(vec(-1, 0, 0), 1), mass_at(vec(1, 0, 0), 1)});
  def.name = "arm";
  def.points[0].name = "tail";
  const BodyId arm = add_body(world, def);
  CHECK(describe(world, arm) == "body 'arm'");
  CHECK(describe(world, world.bodies[arm].points[0]) == "point 'tail' of body 'arm'");
  CHECK(describe(world, world.bodies[arm].points[1]) == "point 2 of body 'arm'");
  CHECK(describe(world, AnyId{}) == "nothing");
  world.who = [] { return std::string("scene.lua:7"); };
  remove(world, arm);
  CHECK(describe(world, arm) == "body 'arm' was removed at 0 s by scene.lua:7");
}

TEST_CASE("touch lists a thing with the articulate that it is in") {
  World world;
  const BodyId id = add_body(world, of_points({mass_at(vec(-1, 0, 0), 1), mass_at(vec(1, 0, 0), 1)}));
  REQUIRE(world.edited_things.size() == 1);
  CHECK(world.edited_things[0].body == id);
  CHECK(world.edited_things[0].articulate == -1);
  world.edited_things.clear();
  world.topology_changed = false;
  world.motion_of(id).articulate = 2;
  mark_edited(world, world.bodies[id].points[0]);
  CHECK(world.topology_changed);
  REQUIRE(world.edited_things.size() == 1);
  CHECK(world.edited_things[0].body == id);
  CHECK(world.edited_things[0].articulate == 2);
  disturb(world, world.bodies[id].points[0]);
  CHECK(world.disturbed == std::vector<std::int32_t>{2});
}

TEST_CASE("a group is gone when it had members and none lives") {
  World world;
  const GroupId group = add_group(world, "chain"), outer = add_group(world, "all");
  CHECK(alive(world, AnyId{group}));
  const ParticleId p = add_particle(world, {});
  add_to_group(world, group, p);
  add_to_group(world, outer, group);
  CHECK(alive(world, AnyId{outer}));
  remove(world, p);
  CHECK_FALSE(alive(world, AnyId{group}));
  CHECK_FALSE(alive(world, AnyId{outer}));
  CHECK_FALSE(alive(world, AnyId{}));
}
