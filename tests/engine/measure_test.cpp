#include "measure/measure.hpp"

#include <catch2/catch.hpp>

#include "edit/constrain.hpp"
#include "support/rods.hpp"

using namespace pantin;
using namespace pantin::test;
using Catch::Contains;

namespace {
ParticleId ball(World& world, double mass, Vec3 at, Vec3 velocity = zero3()) {
  ParticleDef def;
  def.mass = mass;
  def.at = at;
  def.velocity = velocity;
  return add_particle(world, def);
}
}  // namespace

TEST_CASE("energy, momentum and mass are sums over bodies and free points") {
  World world;
  ball(world, 2, vec(0, 3, 0), vec(1, 0, 0));
  BodyDef def;
  def.mass = 5;
  def.inertia = diagonal(vec(2, 2, 2));
  def.at = vec(0, -1, 0);
  def.velocity = vec(0, 2, 0);
  def.spin = vec(0, 0, 3);
  add_body(world, def);
  const Energy e = energy(world);
  CHECK(e.kinetic == Approx(0.5 * 2 * 1 + 0.5 * 5 * 4 + 0.5 * 2 * 9));
  CHECK(e.potential == Approx(9.81 * (2 * 3 - 5 * 1)));
  CHECK(e.total() == e.kinetic + e.potential);
  const Things all = everything(world);
  CHECK(energy(world, all).total() == Approx(e.total()));
  CHECK(mass(world, all) == 7.0);
  CHECK(same(momentum(world, all), vec(2, 10, 0)));
  // r x p of the ball, and of the body nothing but its spin: it moves through the origin.
  CHECK(norm(angular_momentum(world, all) - vec(0, 0, -3 * 2 + 2 * 3)) < 1e-14);
}

TEST_CASE("angular momentum is that of the points one by one") {
  World world;
  BodyDef def = rod_at(vec(3, 1, -2));
  def.points[1].mass = 4;
  def.velocity = vec(1, 2, 3);
  def.spin = vec(0, 0.5, -2);
  const BodyId body = add_body(world, def);
  Vec3 sum = zero3();
  double kinetic = 0.0;
  for (PointId p : world.bodies[body].points) {
    sum += cross(position(world, p), velocity(world, p)) * world.points[p].mass;
    kinetic += 0.5 * world.points[p].mass * norm2(velocity(world, p));
  }
  CHECK(norm(angular_momentum(world, everything(world)) - sum) < 1e-12);
  CHECK(energy(world).kinetic == Approx(kinetic));
}

TEST_CASE("things of a group are counted once, whatever names them") {
  Two t;
  const PointId p = point_of(t.world, ball(t.world, 1, zero3()));
  const GroupId group = add_group(t.world, "g"), inner = add_group(t.world, "inner");
  add_to_group(t.world, inner, t.b);
  add_to_group(t.world, inner, p);
  for (const AnyId& id : {AnyId{t.a}, AnyId{t.hinge}, AnyId{left_of(t.world, t.a)}, AnyId{inner}, AnyId{p}})
    add_to_group(t.world, group, id);
  const Things things = things_of(t.world, group);
  CHECK(things.bodies == std::vector<BodyId>{t.a, t.b});
  CHECK(things.free_points == std::vector<PointId>{p});
  remove(t.world, t.b);
  CHECK(things_of(t.world, group).bodies == std::vector<BodyId>{t.a});
  CHECK_THROWS_WITH(things_of(t.world, t.b), Contains("was removed"));
}

TEST_CASE("temperature is 2 E_k over the degrees of freedom, relative to the common motion") {
  World world;
  ball(world, 1, vec(0, 0, 0), vec(10 + 1, 0, 0));
  ball(world, 1, vec(1, 0, 0), vec(10 - 1, 0, 0));
  // E_k of the relative motion is 1 J; 2 x 3 - 3 degrees of freedom
  CHECK(temperature(world, everything(world)) == Approx(2.0 * 1.0 / 3.0));
  world.settings.boltzmann = 0.5;
  CHECK(temperature(world, everything(world)) == Approx(4.0 / 3.0));
}

TEST_CASE("a falling body is not hot, and one particle has no temperature") {
  World world;
  const BodyId body = add_body(world, rod_at(zero3()));
  set_velocity(world, body, vec(0, -30, 0));
  CHECK(temperature(world, everything(world)) == 0.0);
  World lone;
  ball(lone, 1, zero3(), vec(1, 0, 0));
  CHECK(temperature(lone, everything(lone)) == 0.0);
}

TEST_CASE("hinges, nails and rods take degrees of freedom away") {
  Two t;
  set_spin(t.world, t.a, vec(0, 0, 2));
  set_spin(t.world, t.b, vec(0, 0, -2));
  const double kinetic = 2 * 0.5 * 0.5 * 4;  // two rods of inertia 1/2
  const Things all = everything(t.world);
  CHECK(temperature(t.world, all) == Approx(2 * kinetic / (5 + 5 - 3 - 3)));
  const ConstraintId rod = add_rod(t.world, left_of(t.world, t.a), right_of(t.world, t.b));
  CHECK(temperature(t.world, all) == Approx(2 * kinetic / (5 + 5 - 3 - 1 - 3)));
  set_enabled(t.world, rod, false);
  add_nail(t.world, left_of(t.world, t.a));  // no common motion any more
  CHECK(temperature(t.world, all) == Approx(2 * kinetic / (5 + 5 - 3 - 3)));
  // A set of one rod: its hinge to the other takes nothing, its nail does.
  CHECK(temperature(t.world, things_of(t.world, t.a)) == Approx(2 * (kinetic / 2) / (5 - 3)));
}

TEST_CASE("accuracy finds the gaps of hinges, nails and rods") {
  Two t;
  CHECK(accuracy(t.world).constraint == 0.0);
  const ConstraintId rod = add_rod(t.world, left_of(t.world, t.a), right_of(t.world, t.b));
  set_length(t.world, rod, 1.75);  // drawn in, so no error
  CHECK(accuracy(t.world).constraint == 0.0);
  set_position(t.world, t.b, t.world.motion_of(t.b).x + vec(0.25, 0, 0));
  CHECK(accuracy(t.world).constraint == Approx(0.25));
  set_position(t.world, t.b, t.world.motion_of(t.b).x - vec(0.25, 0, 0));
  set_enabled(t.world, rod, false);
  set_position(t.world, t.b, t.world.motion_of(t.b).x + vec(0, 0.125, 0));
  CHECK(accuracy(t.world).hinge_gap == Approx(0.125));
  add_nail(t.world, left_of(t.world, t.a), vec(0, 5, 0));  // far away: drawn in, so no error
  CHECK(accuracy(t.world).hinge_gap == Approx(0.125));
  set_position(t.world, t.a, t.world.motion_of(t.a).x + vec(0, 0.5, 0));
  CHECK(accuracy(t.world).hinge_gap == Approx(0.5));
}

TEST_CASE("equal states have equal hashes, and any bit of a difference shows") {
  const auto make = [](double x) {
    auto world = std::make_unique<World>();
    add_body(*world, rod_at(vec(x, 0, 0)));
    ball(*world, 1, vec(x, 0, 0));
    return state_hash(*world);
  };
  CHECK(make(1.0) == make(1.0));
  CHECK(make(1.0) != make(std::nextafter(1.0, 2.0)));
}

TEST_CASE("bounds hold all points; of nothing they are nothing") {
  Two t;
  ball(t.world, 1, vec(-1, 2, -3));
  const Bounds box = bounds(t.world, everything(t.world));
  CHECK(norm(box.low - vec(-1, 0, -3)) < 1e-14);
  CHECK(norm(box.high - vec(2, 2, 0)) < 1e-14);
  CHECK(same(bounds(t.world, Things{}).high, zero3()));
}

TEST_CASE("clusters are what is within the distance, biggest first") {
  World world;
  const GroupId group = add_group(world, "balls");
  std::vector<AnyId> ids;
  for (double x : {10.0, 0.0, 11.0, 1.0, 2.0, 20.0}) {
    const ParticleId p = ball(world, 1, vec(x, 0, 0));
    ids.emplace_back(point_of(world, p));
    add_to_group(world, group, p);
  }
  const auto found = clusters(world, group, 1.0);
  REQUIRE(found.size() == 3);
  CHECK(found[0] == std::vector<AnyId>{ids[1], ids[3], ids[4]});
  CHECK(found[1] == std::vector<AnyId>{ids[0], ids[2]});
  CHECK(found[2] == std::vector<AnyId>{ids[5]});
  CHECK(clusters(world, group, 0.5).size() == 6);
  set_box(world, vec(21, 5, 5));
  CHECK(clusters(world, group, 1.0)[0] == std::vector<AnyId>{ids[1], ids[3], ids[4], ids[5]});
  CHECK_THROWS_WITH(clusters(world, group, -1), Contains("distance must be >= 0 m"));
}
