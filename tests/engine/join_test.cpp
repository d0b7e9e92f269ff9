#include "edit/constrain.hpp"
#include "edit/edit.hpp"

#include <catch2/catch.hpp>

#include "measure/measure.hpp"
#include "measure/query.hpp"
#include "support/rods.hpp"

using namespace pantin;
using namespace pantin::test;
using Catch::Contains;

TEST_CASE("a hinge makes a new particle of its points, and theirs sleep") {
  Two t;
  const Particle& ring = t.world.particles[t.hinge];
  CHECK(ring.points == std::vector<PointId>{right_of(t.world, t.a), left_of(t.world, t.b)});
  for (PointId p : ring.points) {
    CHECK(t.world.points[p].particle == t.hinge);
    CHECK(t.world.particles[t.world.points[p].own].asleep_in == t.hinge);
  }
  CHECK(mass(t.world, t.hinge) == 2.0);
}

TEST_CASE("a hinge has the data given, else those of its first point") {
  World world;
  ParticleDef red, blue;
  red.color = {1, 0, 0, 1};
  red.radius = 0.3;
  blue.color = {0, 0, 1, 1};
  const PointId a = point_of(world, add_particle(world, red)), b = point_of(world, add_particle(world, blue));
  const ParticleId first = join(world, {a, b});
  CHECK(world.particles[first].color == red.color);
  CHECK(world.particles[first].radius == 0.3);
  cut(world, first);
  HingeDef def;
  def.color = Color{0, 1, 0, 1};
  def.radius = 0.7;
  const ParticleId second = join(world, {a, b}, def);
  CHECK(world.particles[second].color == def.color);
  cut(world, second);
  for (PointId p : {a, b}) {
    CHECK(world.particles[world.points[p].own].color == def.color);
    CHECK(world.particles[world.points[p].own].radius == 0.7);
  }
}

TEST_CASE("hinges that share a new hinge unite in it") {
  World world;
  std::vector<BodyId> b;
  for (int i = 0; i < 4; i++) b.push_back(add_body(world, rod_at(zero3())));
  const ParticleId first = join(world, {left_of(world, b[0]), left_of(world, b[1])}),
                   second = join(world, {left_of(world, b[2]), left_of(world, b[3])});
  HingeDef def;
  def.name = "hub";
  const ParticleId hub = join(world, {left_of(world, b[1]), left_of(world, b[2])}, def);
  CHECK(world.particles[hub].points.size() == 4);
  for (BodyId body : b) CHECK(world.points[left_of(world, body)].particle == hub);
  CHECK(hinges(world) == std::vector<ParticleId>{hub});
  CHECK_THROWS_WITH(world.particles[first], Contains("was removed at 0 s by joining into hinge 'hub'"));
  CHECK_THROWS_WITH(world.particles[second], Contains("by joining into hinge 'hub'"));
  CHECK_THROWS_WITH(join(world, {left_of(world, b[0]), left_of(world, b[3])}),
                    "hinge: these points are joined already, in hinge 'hub'");
}

TEST_CASE("a hinge that takes the place of another keeps its name and what it bears, unless it is told others") {
  World world;
  std::vector<BodyId> b;
  for (int i = 0; i < 4; i++) b.push_back(add_body(world, rod_at(zero3())));
  HingeDef def;
  def.name = "neck";
  const ParticleId first = join(world, {left_of(world, b[0]), left_of(world, b[1])}, def);
  set_breaks_at(world, first, Breaking{.force = 100.0});
  const ParticleId second = join(world, {left_of(world, b[0]), left_of(world, b[2])});
  CHECK(world.particles[second].name == "neck");
  CHECK(world.particles[second].breaks_at.force == 100.0);
  def.name = "spine";
  const ParticleId third = join(world, {left_of(world, b[0]), left_of(world, b[3])}, def);
  CHECK(world.particles[third].name == "spine");
  CHECK(world.particles[third].breaks_at.force == 100.0);
}

TEST_CASE("a hinge joins different bodies at one position") {
  Two t;
  const PointId al = left_of(t.world, t.a), br = right_of(t.world, t.b);
  CHECK_THROWS_WITH(join(t.world, {al}), "hinge: needs two points or more, got 1");
  CHECK_THROWS_WITH(join(t.world, {al, al}), "hinge: points 1 and 2 are the same point");
  CHECK_THROWS_WITH(join(t.world, {al, right_of(t.world, t.a)}),
                    "hinge: points 1 and 2 both belong to body 'a'; a hinge joins different bodies");
  CHECK_THROWS_WITH(join(t.world, {al, left_of(t.world, t.b)}), Contains("both belong to body 'a'"));
  CHECK_THROWS_WITH(join(t.world, {al, br}),
                    Contains("points 1 and 2 are 2 m apart") && Contains("move them together"));
  CHECK(hinges(t.world).size() == 1);
}

TEST_CASE("points of a hinge may be apart by the tolerance times the size of their bodies") {
  World world;
  const BodyId a = add_body(world, rod_at(zero3())), b = add_body(world, rod_at(vec(1 + 0.9e-6, 0, 0)));
  CHECK_NOTHROW(join(world, {right_of(world, a), left_of(world, b)}));
  const BodyId c = add_body(world, rod_at(vec(2 + 3e-6, 0, 0)));
  CHECK_THROWS_WITH(join(world, {right_of(world, b), left_of(world, c)}), Contains("apart"));
}

TEST_CASE("points without bodies may be apart by the tolerance times the largest coordinate") {
  World world;
  ParticleDef def;
  const PointId p = point_of(world, add_particle(world, def));
  def.at = vec(1e-9, 0, 0);
  const PointId q = point_of(world, add_particle(world, def));
  CHECK_THROWS_WITH(join(world, {p, q}),
                    Contains("1e-09 m apart, and at most 1e-15 m (scene.tolerance times the largest coordinate"));
  def.at = vec(0, 1, 0);
  add_particle(world, def);
  CHECK_NOTHROW(join(world, {p, q}));
}

TEST_CASE("cutting frees all members and keeps momentum, position and velocity") {
  Two t;
  kick(t.world, t.a, vec(1, 2, 0), vec(0.3, 0, 0));
  const Things all = everything(t.world);
  const Vec3 p = momentum(t.world, all), l = angular_momentum(t.world, all);
  cut(t.world, t.hinge);
  CHECK(same(momentum(t.world, all), p));
  CHECK(same(angular_momentum(t.world, all), l));
  CHECK_FALSE(t.world.particles.alive(t.hinge));
  for (PointId id : {right_of(t.world, t.a), left_of(t.world, t.b)}) {
    CHECK(t.world.points[id].particle == t.world.points[id].own);
    CHECK_FALSE(t.world.particles[t.world.points[id].own].asleep_in);
  }
  REQUIRE(t.world.notices.size() == 1);
  CHECK(t.world.notices[0].kind == Notice::Kind::cut);
  CHECK_THROWS_WITH(cut(t.world, t.hinge), Contains("was removed at 0 s by the program"));
  CHECK_THROWS_WITH(cut(t.world, t.world.points[left_of(t.world, t.b)].own), Contains("is no hinge"));
}

TEST_CASE("one body is cut out of a hinge of three; of two the hinge ends") {
  Two t;
  const BodyId c = add_body(t.world, rod_at(vec(1, 0, 0), "c")), other = add_body(t.world, rod_at(zero3(), "other"));
  const ParticleId ring = join(t.world, {left_of(t.world, t.b), left_of(t.world, c)});
  CHECK(t.world.particles[ring].points.size() == 3);
  CHECK_THROWS_WITH(cut(t.world, ring, other), Contains("body 'other' is not in hinge"));
  cut(t.world, ring, t.b);
  CHECK(t.world.particles[ring].points.size() == 2);
  CHECK(t.world.points[left_of(t.world, t.b)].particle == t.world.points[left_of(t.world, t.b)].own);
  cut(t.world, ring, c);
  CHECK_FALSE(t.world.particles.alive(ring));
  CHECK(hinges(t.world).empty());
}

TEST_CASE("a removed body takes its points, constraints and positions in hinges along") {
  Two t;
  const PointId bl = left_of(t.world, t.b), al = left_of(t.world, t.a);
  const ConstraintId nail = add_nail(t.world, al), rod = add_rod(t.world, al, right_of(t.world, t.b));
  t.world.who = [] { return std::string("scene.lua:3"); };
  t.world.edited_things.clear();
  remove(t.world, t.a);
  CHECK_FALSE(t.world.points.alive(al));
  CHECK_FALSE(t.world.particles.alive(t.hinge));
  CHECK(t.world.particles.alive(t.world.points[bl].own));
  CHECK(t.world.points[right_of(t.world, t.b)].constraints.empty());
  CHECK_THROWS_WITH(t.world.constraints[nail], Contains("by scene.lua:3"));
  CHECK_THROWS_WITH(t.world.constraints[rod], Contains("by scene.lua:3"));
  CHECK_THROWS_WITH(remove(t.world, t.a), "body 'a' was removed at 0 s by scene.lua:3");
  CHECK(std::any_of(t.world.edited_things.begin(), t.world.edited_things.end(),
                    [&](const EditedThing& it) { return it.body == t.b; }));
  CHECK(t.world.points.size() == 2);
  CHECK(t.world.particles.size() == 2);
}

TEST_CASE("a body's point goes by remove_point, a free one by remove") {
  World world;
  BodyDef def = rod_at(zero3(), "arm");
  def.points.push_back({});
  def.points[2].at = vec(0.5, 0, 0);
  const BodyId arm = add_body(world, def);
  const PointId middle = world.bodies[arm].points[2];
  CHECK_THROWS_WITH(remove(world, world.points[middle].own), Contains("use remove_point"));
  remove_point(world, middle);
  CHECK(world.bodies[arm].points.size() == 2);
  remove_point(world, right_of(world, arm));
  CHECK(world.motion_of(arm).freedom == Freedom::point);
  CHECK_THROWS_WITH(remove_point(world, left_of(world, arm)), Contains("mass must be > 0 kg"));
  CHECK(world.bodies[arm].points.size() == 1);
  const PointId free_point = point_of(world, add_particle(world, {}));
  CHECK_THROWS_WITH(remove_point(world, free_point), Contains("belongs to no body"));
  remove(world, free_point);
  CHECK(world.particles.size() == 1);
}
