#include "choreography/commands.hpp"

#include <catch2/catch.hpp>

#include "edit/assemble.hpp"
#include "measure/measure.hpp"
#include "measure/query.hpp"
#include "step/step.hpp"
#include "support/rods.hpp"

using namespace pantin;
using namespace pantin::test;
using Catch::Contains;
using Kind = Command::Kind;

namespace {

Command command(Kind kind, PointId point = {}) {
  Command c;
  c.kind = kind;
  c.point = point;
  return c;
}

void act(World& world, const Command& c) { carry_out(world, std::vector{c}); }

/// The one line of the log.
std::string dropped(const World& world) {
  REQUIRE(world.log.size() == 1);
  CHECK(world.log[0].kind == "dropped");
  return world.log[0].text;
}

}  // namespace

TEST_CASE("a hand cuts connections and constraints as well as hinges, and what it cut says so") {
  World world;
  const ParticleId a = add_particle(world, {}), b = [&] {
    ParticleDef def;
    def.at = vec(1, 0, 0);
    return add_particle(world, def);
  }();
  const ConstraintId nail = add_nail(world, point_of(world, a)),
                     rod = add_rod(world, point_of(world, a), point_of(world, b));
  for (const AnyId& thing : {AnyId(nail), AnyId(rod)}) {
    Command c = command(Kind::cut);
    c.thing = thing;
    c.hand = 2;
    act(world, c);
    CHECK_FALSE(alive(world, thing));
    CHECK(world.notices.back().hand == 2);
  }
  CHECK_THROWS_WITH(world.constraints[nail], Contains("by hand 3"));
  Command c = command(Kind::cut);
  c.thing = a;
  act(world, c);
  CHECK_THAT(dropped(world), Contains("cut by hand 1") && Contains("is no hinge"));
}

TEST_CASE("a hand joins points of two bodies, which become a hinge, and not of one") {
  World world;
  world.settings.gravity = zero3();
  const BodyId a = add_body(world, rod_at(vec(0, 0, 0))), b = add_body(world, rod_at(vec(1.5, 0, 0)));
  Command c = command(Kind::join, right_of(world, a));
  c.other = left_of(world, b);
  act(world, c);
  for (int i = 0; i < 1000 && hinges(world).empty(); i++) step(world);
  REQUIRE(hinges(world).size() == 1);
  CHECK(norm(momentum(world, everything(world))) < 1e-12);
  CHECK(world.log.empty());
  c.other = left_of(world, a);
  act(world, c);
  CHECK_THAT(dropped(world), Contains("join by hand 1") && Contains("both points belong to"));
}

TEST_CASE("a hand nails, pushes and spins") {
  World world;
  world.settings.gravity = zero3();
  BodyDef def = rod_at(vec(0, 0, 0));
  def.inertia = diagonal(vec(1, 1, 1));
  const BodyId body = add_body(world, def);
  Command c = command(Kind::push, right_of(world, body));
  c.amount = vec(0, 6, 0);
  act(world, c);
  CHECK(norm(momentum(world, everything(world)) - vec(0, 6, 0)) < 1e-12);
  c = command(Kind::spin, left_of(world, body));
  const Vec3 before = angular_momentum(world, body);
  c.amount = vec(3, 0, 0);
  act(world, c);
  CHECK(norm(angular_momentum(world, body) - before - inertia(world, body) * vec(3, 0, 0)) < 1e-12);
  act(world, command(Kind::nail, left_of(world, body)));
  const Vec3 there = position(world, left_of(world, body));
  for (int i = 0; i < 10; i++) step(world);
  CHECK(norm(position(world, left_of(world, body)) - there) < 1e-9);
  CHECK(world.log.empty());
  act(world, command(Kind::spin, point_of(world, add_particle(world, {}))));
  CHECK_THAT(dropped(world), Contains("is a free particle, which cannot turn"));
}

TEST_CASE("a hand removes things") {
  Two t;
  Command c = command(Kind::remove);
  c.thing = t.a;
  act(t.world, c);
  CHECK_FALSE(t.world.bodies.alive(t.a));
  CHECK_FALSE(t.world.particles.alive(t.hinge));
  act(t.world, c);
  CHECK_THAT(dropped(t.world), Contains("remove by hand 1") && Contains("was removed at 0 s by hand 1"));
}

TEST_CASE("a hand makes a ball of one point and a body of more, with its mass and its ends hinged") {
  Two t;
  Command c = command(Kind::make);
  c.position = vec(0, 3, 0);
  c.points = {zero3()};
  c.mass = 2;
  c.radius = 0.3;
  act(t.world, c);
  CHECK(mass(t.world, everything(t.world)) == Approx(6));
  CHECK(near(t.world, c.position, 1e-9).size() == 1);

  c.points = {vec(-1, 0, 0), vec(1, 0, 0)};
  c.other = right_of(t.world, t.b);
  act(t.world, c);
  CHECK(mass(t.world, everything(t.world)) == Approx(8));
  REQUIRE(hinges(t.world).size() == 2);
  CHECK(norm(position(t.world, hinges(t.world)[1]) - vec(2, 0, 0)) < 1e-12);
  CHECK(t.world.log.empty());

  SECTION("not at a position that is no number") { c.position = vec(0, std::nan(""), 0); }
  SECTION("not without mass") { c.mass = 0; }
  SECTION("not between a point and itself") { c.point = c.other; }
  const auto bodies = t.world.bodies.ids().size();
  act(t.world, c);
  CHECK_THAT(dropped(t.world), Contains("make by hand 1"));
  CHECK(t.world.bodies.ids().size() == bodies);
}

TEST_CASE("a hand heats and cools what is in a ball, and cools at most to rest") {
  World world;
  for (int i = 0; i < 8; i++) {
    ParticleDef def;
    def.at = vec(i, 0, 0);
    add_particle(world, def);
  }
  Command c = command(Kind::heat);
  c.position = vec(1, 0, 0);
  c.radius = 2.5;
  c.energy = 3;
  act(world, c);
  CHECK(energy(world).kinetic == Approx(3));
  CHECK(norm(momentum(world, everything(world))) < 1e-12);
  CHECK(norm(velocity(world, particles(world)[4])) == 0);
  c.energy = -100;
  act(world, c);
  CHECK(energy(world).kinetic < 1e-20);
  CHECK(world.log.empty());
  c.position = vec(0, 50, 0);
  act(world, c);
  CHECK_THAT(dropped(world), Contains("there is nothing to heat"));
}

TEST_CASE("a hand that would heat a single ball at rest leaves it, and says nothing") {
  World world;
  ParticleDef def;
  def.at = vec(0, 0, 0);
  add_particle(world, def);
  Command c = command(Kind::heat);
  c.position = vec(0, 0, 0);
  c.radius = 1;
  c.energy = 3;
  act(world, c);
  CHECK(energy(world).kinetic == 0);
  CHECK(world.log.empty());
}

TEST_CASE("a hand heats bodies without points where their shapes reach into the ball") {
  World world;
  std::vector<BodyId> boxes;
  for (int i = 0; i < 3; i++) {
    BodyDef def;
    def.at = vec(2 * i, 0, 0);
    ShapeDef& shape = def.shapes.emplace_back();
    shape.geometry = BoxShape{vec(0.5, 0.5, 0.5)};
    boxes.push_back(add_body(world, def));
  }
  Command c = command(Kind::heat);
  c.position = vec(1, 0, 0);
  c.radius = 0.6;
  c.energy = 3;
  act(world, c);
  CHECK(world.log.empty());
  CHECK(energy(world).kinetic == Approx(3));
  CHECK(norm(world.motion_of(boxes[0]).p) > 0);
  CHECK(norm(world.motion_of(boxes[1]).p) > 0);
  CHECK(norm(world.motion_of(boxes[2]).p) == 0);
  CHECK(heated_by(world, vec(1, 0, 0), 0.4).bodies.empty());
  CHECK_FALSE(takes_heat(world, heated_by(world, vec(4.6, 0, 0), 0.2), 3));
}
