#include "edit/assemble.hpp"

#include <catch2/catch.hpp>

#include "edit/constrain.hpp"
#include "laws/library.hpp"
#include "laws/run/sites.hpp"
#include "measure/measure.hpp"
#include "measure/query.hpp"
#include "step/step.hpp"
#include "support/balance.hpp"
#include "support/cases.hpp"

using namespace pantin;
using namespace pantin::cases;
using Catch::Contains;

namespace {

double merged(const World& world) { return world.ledger.given[static_cast<std::size_t>(Source::merge)]; }

}  // namespace

TEST_CASE("merging keeps mass, centre and momenta, and tells what kinetic energy is lost") {
  for (int i = 0; i < 50; i++) {
    World world;
    BodyMaker make;
    make.random.seed = static_cast<std::uint64_t>(i);
    BodyDef first = make.body(), second = make.body();
    if (i % 2) second.mass = 1.5, second.inertia = diagonal(vec(0.3, 0.4, 0.5));
    if (i % 3) first.mass = 0.7;
    const BodyId a = add_body(world, first), b = add_body(world, second);
    const PointId of_b = world.bodies[b].points[1];
    const Vec3 at = position(world, of_b);
    const double before = energy(world).kinetic;
    expect_kept(world, [&] { merge(world, a, b); });
    CHECK(norm(position(world, of_b) - at) < 1e-13);
    CHECK(world.points[of_b].body == a);
    CHECK(merged(world) < 0.0);
    CHECK(merged(world) == Approx(energy(world).kinetic - before).margin(1e-10));
    CHECK_THAT(world.bodies.story(b), Contains("merging it into body"));
  }
}

TEST_CASE("two equal masses that meet head on lose all their energy by merging") {
  World world;
  world.settings.gravity = zero3();
  BodyDef def;
  def.mass = 1.0;
  def.at = vec(-1, 0, 0);
  def.velocity = vec(2, 0, 0);
  const BodyId a = add_body(world, def);
  def.at = vec(1, 0, 0);
  def.velocity = vec(-2, 0, 0);
  const BodyId b = add_body(world, def);
  merge(world, a, b);
  CHECK(merged(world) == Approx(-4.0));
  CHECK(energy(world).kinetic == Approx(0.0).margin(1e-15));
  step(world);
  CHECK(world.failure.empty());
}

TEST_CASE("what ties two bodies ends when they merge, what ties them to others stays") {
  World world;
  const Chain chain = add_chain(world, {.links = 4, .pinned = true});
  MotorDef drive;
  drive.axis = vec(0, 0, 1);
  drive.speed = 1.0;
  const ConstraintId motor = add_motor(world, chain.bodies[2], chain.bodies[3], drive);
  merge(world, chain.bodies[1], chain.bodies[2]);
  CHECK(hinges(world).size() == 2);
  CHECK(world.constraints[motor].body_a == chain.bodies[1]);
  CHECK(world.constraints[chain.pin].a == chain.heads[0]);
  const double gap = [&] {
    advance(world, 1.0);
    return world.worst.hinge_gap;
  }();
  CHECK(gap < 1e-9);
  CHECK(world.failure.empty());
}

TEST_CASE("a body splits into two that move as its parts did, and merges again to what it was") {
  for (int i = 0; i < 50; i++) {
    World world;
    BodyMaker make;
    make.random.seed = static_cast<std::uint64_t>(100 + i);
    BodyDef def = make.body(6);
    if (i % 2) def.mass = 2.0, def.inertia = diagonal(vec(1, 1, 1));
    const BodyId body = add_body(world, def);
    const std::vector<PointId> all = world.bodies[body].points;
    const std::vector<PointId> some(all.begin(), all.begin() + 1 + i % 4);
    std::vector<Vec3> positions, velocities;
    for (PointId p : all) positions.push_back(position(world, p)), velocities.push_back(velocity(world, p));
    const double before = energy(world).kinetic;
    BodyId fresh;
    expect_kept(world, [&] { fresh = split(world, body, some); });
    for (std::size_t k = 0; k < all.size(); k++) {
      CHECK(norm(position(world, all[k]) - positions[k]) < 1e-12);
      CHECK(norm(velocity(world, all[k]) - velocities[k]) < 1e-10);
    }
    expect_kept(world, [&] { merge(world, body, fresh); });
    CHECK(energy(world).kinetic == Approx(before));
    CHECK(world.motion_of(body).mass == Approx(mass(world, everything(world))));
  }
}

TEST_CASE("a hinge goes with the point that is split off, its axis too") {
  World world;
  world.settings.gravity = zero3();
  BodyDef def;
  for (double x : {-1.0, 0.0, 1.0})
    for (double y : {-0.1, 0.1}) {
      PointDef p;
      p.at = vec(x, y, 0);
      p.mass = 1.0;
      def.points.push_back(p);
    }
  const BodyId a = add_body(world, def);
  def.at = vec(2, 0, 0);
  const BodyId b = add_body(world, def);
  const PointId points[] = {world.bodies[a].points[4], world.bodies[b].points[0]};
  HingeDef turning;
  turning.axis = vec(0, 0, 1);
  add_hinge(world, points, turning);
  const PointId off[] = {world.bodies[a].points[4], world.bodies[a].points[5]};
  const BodyId fresh = split(world, a, off);
  CHECK(world.bodies[a].constraints.empty());
  CHECK(world.bodies[fresh].constraints.size() == 1);
  set_velocity(world, a, vec(0, 0, 1));
  advance(world, 0.5);
  CHECK(world.motion_of(a).x[2] == Approx(0.5));
  CHECK(norm(world.motion_of(b).x - vec(2, 0, 0)) < 1e-12);
}

TEST_CASE("others of a hinge keep its axis when a body of it becomes a point, or shatters") {
  for (const bool shattered : {false, true}) {
    World world;
    world.settings.gravity = zero3();
    BodyDef def;
    for (Vec3 at : {vec(0, 0, 0), vec(1, 0, 0), vec(0, 1, 0)}) {
      PointDef p;
      p.at = at;
      p.mass = 1.0;
      def.points.push_back(p);
    }
    std::vector<PointId> ring;
    for (int i = 0; i < 3; i++) ring.push_back(world.bodies[add_body(world, def)].points[0]);
    HingeDef turning;
    turning.axis = vec(0, 0, 1);
    const ParticleId hinge = add_hinge(world, ring, turning);
    REQUIRE(world.particles[hinge].axes.size() == 2);
    const BodyId first = world.points[ring[0]].body, second = world.points[ring[1]].body;
    if (shattered)
      shatter(world, first);
    else
      split(world, first, std::vector{world.bodies[first].points[1], world.bodies[first].points[2]});
    REQUIRE(world.particles[hinge].axes.size() == 1);
    const Constraint& axis = world.constraints[world.particles[hinge].axes[0]];
    CHECK(axis.body_a == second);
    CHECK(axis.body_b == world.points[ring[2]].body);
    set_spin(world, second, vec(1, 2, 3));
    advance(world, 0.2);
    CHECK(world.error.constraint < 1e-9);
    CHECK(world.failure.empty());
  }
}

TEST_CASE("a group of bodies freezes to its first, of bodies and particles to one more") {
  World world;
  BodyMaker make;
  const BodyId a = add_body(world, make.body()), b = add_body(world, make.body());
  const GroupId group = add_group(world, "wreck");
  add_to_group(world, group, b);
  add_to_group(world, group, a);
  expect_kept(world, [&] { CHECK(freeze(world, group, "lump") == a); });
  CHECK(world.bodies[a].name == "lump");
  ParticleDef def;
  def.at = vec(5, 0, 0);
  add_to_group(world, group, add_particle(world, def));
  BodyId all;
  expect_kept(world, [&] { all = freeze(world, group); });
  CHECK(world.bodies.size() == 1);
  CHECK(world.bodies[all].points.size() == 9);
}

TEST_CASE("freezing and shattering keep what merging keeps") {
  for (int i = 0; i < 30; i++) {
    World world;
    BodyMaker make;
    make.random.seed = static_cast<std::uint64_t>(200 + i);
    const GroupId group = add_group(world, "crystal");
    for (int k = 0; k < 3 + i; k++) {
      ParticleDef def;
      def.at = make.place(2.0);
      def.velocity = make.place(1.0);
      def.mass = make.number(0.1, 2.0);
      add_to_group(world, group, add_particle(world, def));
    }
    const std::size_t count = world.points.size();
    BodyId body;
    expect_kept(world, [&] { body = freeze(world, group); });
    CHECK(world.bodies[body].points.size() == count);
    CHECK(merged(world) < 0.0);
    step(world);
    std::vector<ParticleId> pieces;
    expect_kept(world, [&] { pieces = shatter(world, body); });
    CHECK(pieces.size() == count);
    CHECK(world.bodies.empty());
    step(world);
    CHECK(world.failure.empty());
  }
}

TEST_CASE("a body with a mass of its own shatters into that too, where its spin can be carried") {
  World world;
  BodyMaker make;
  BodyDef def = make.body(3);
  def.mass = 1.0;
  const BodyId body = add_body(world, def);
  expect_kept(world, [&] { CHECK(shatter(world, body).size() == 4); });
  BodyDef ball;
  ball.mass = 1.0;
  ball.inertia = diagonal(vec(1, 1, 1));
  ball.spin = vec(0, 1, 0);
  const BodyId spinning = add_body(world, ball);
  CHECK_THROWS_WITH(shatter(world, spinning),
                    Contains("1 particle at these positions cannot carry its angular momentum"));
  CHECK(world.bodies.alive(spinning));
  set_spin(world, spinning, zero3());
  CHECK(shatter(world, spinning).size() == 1);
}

TEST_CASE("welding and cutting keep momenta over the step") {
  World world;
  world.settings.gravity = zero3();
  BodyMaker make;
  const BodyId a = add_body(world, make.body()), b = add_body(world, make.body());
  const Balance before = balance_of(world);
  const BalanceScale scale = scale_of(world);
  add_weld(world, a, b);
  for (int i = 0; i < 10; i++) step(world);
  const Balance after = balance_of(world);
  CHECK(norm(after.momentum - before.momentum) <= 1e-13 * scale.momentum);
  CHECK(norm(after.angular - before.angular) <= 1e-13 * scale.angular);
}

TEST_CASE("bad merges, splits and freezes are errors, and the scene is as it was") {
  World world;
  BodyMaker make;
  const BodyId a = add_body(world, make.body(2)), b = add_body(world, make.body(2));
  const std::uint64_t hash = state_hash(world);
  CHECK_THROWS_WITH(merge(world, a, a), Contains("merge: both are body") && Contains("needs two bodies"));
  CHECK_THROWS_WITH(split(world, a, {}), Contains("split: no points were given"));
  const std::vector<PointId> all = world.bodies[a].points, other = world.bodies[b].points;
  CHECK_THROWS_WITH(split(world, a, all), Contains("these are all points of body"));
  CHECK_THROWS_WITH(split(world, a, other), Contains("is not of body"));
  const PointId twice[] = {all[0], all[0]};
  CHECK_THROWS_WITH(split(world, a, twice), Contains("is given twice"));
  const GroupId group = add_group(world, "g");
  CHECK_THROWS_WITH(freeze(world, group), Contains("there is nothing in group 'g'"));
  add_to_group(world, group, all[0]);
  CHECK_THROWS_WITH(freeze(world, group), Contains("group 'g' has points of body") && Contains("not the body itself"));
  CHECK(state_hash(world) == hash);
  CHECK(world.bodies[a].points == all);
  remove(world, b);
  CHECK_THROWS_WITH(merge(world, a, b), Contains("merge: body") && Contains("was removed"));
}

TEST_CASE("a group's connections break, those to others stay") {
  World world;
  const GroupId group = add_group(world, "block");
  std::vector<ParticleId> line;
  for (int i = 0; i < 5; i++) {
    ParticleDef def;
    def.at = vec(i, 0, 0);
    line.push_back(add_particle(world, def));
    if (i < 4) add_to_group(world, group, line.back());
  }
  LawArguments arguments;
  arguments.numbers = {{"stiffness", 1.0}, {"length", 1.0}};
  const auto law = std::make_shared<const Law>(make_library_law("spring", arguments).front());
  const auto tie = [&](ParticleId a, ParticleId b) {
    ConnectionDef def;
    def.ends = {{a, zero3()}, {b, zero3()}};
    add_connection(world, law, def);
  };
  for (const auto& pair : pairs_within(world, group, 1.1)) tie(pair[0], pair[1]);
  CHECK(world.connections.size() == 3);
  CHECK(pairs_within(world, group, 1.1).empty());
  tie(line[3], line[4]);
  for (ConnectionId id : connections_in(world, group)) remove(world, id);
  CHECK(world.connections.size() == 1);
}

TEST_CASE("pairs that are near are those that a look at all finds, in a sheet, in a cloud and in a box") {
  for (int i = 0; i < 12; i++) {
    World world;
    BodyMaker make;
    make.random.seed = static_cast<std::uint64_t>(i);
    if (i % 2) world.settings.box = vec(4, 5, 6);
    std::vector<ParticleId> list;
    for (int k = 0; k < 120; k++) {
      ParticleDef def;
      def.at = make.place(8.0);
      if (i % 3 == 0) def.at[0] = 1.0;
      list.push_back(add_particle(world, def));
    }
    const double distance = make.number(0.1, 3.5);
    const Box box{world.settings.box.value_or(zero3())};
    std::vector<std::array<ParticleId, 2>> expected;
    for (std::size_t a = 0; a < list.size(); a++)
      for (std::size_t b = a + 1; b < list.size(); b++)
        if (norm(box.nearest(position(world, list[b]) - position(world, list[a]))) <= distance)
          expected.push_back({list[a], list[b]});
    CHECK(pairs_within(world, list, distance) == expected);
  }
}

TEST_CASE("what is measured of ends across the border of a box is the short way") {
  World world;
  world.settings.box = vec(10, 10, 10);
  std::vector<End> ends;
  for (Vec3 at : {vec(9.5, 1, 0.5), vec(0.5, 1, 0.5), vec(0.5, 1, 9.5)}) {
    ParticleDef def;
    def.at = at;
    ends.push_back({add_particle(world, def), zero3()});
  }
  CHECK(present_value(world, std::span(ends).first(2)) == Approx(1.0));
  CHECK(present_value(world, ends) == Approx(std::acos(0.0)));
}

TEST_CASE("heat is kinetic energy, and leaves the common motion") {
  World world;
  BodyMaker make;
  const GroupId group = add_group(world, "gas");
  for (int i = 0; i < 20; i++) {
    ParticleDef def;
    def.at = make.place(2.0);
    def.velocity = vec(1, 0, 0);
    add_to_group(world, group, add_particle(world, def));
  }
  const double before = energy(world).kinetic;
  heat(world, group, 5.0);
  CHECK(energy(world).kinetic == Approx(before + 5.0));
  CHECK(norm(momentum(world, everything(world)) - vec(20, 0, 0)) < 1e-12);
  heat(world, group, 5.0);
  CHECK(temperature(world, everything(world)) == Approx(2.0 * 10.0 / 57.0));
  CHECK_THROWS_WITH(heat(world, group, -11.0), Contains("11 J are to be taken, and there are only"));
  heat(world, group, -10.0);
  CHECK(temperature(world, everything(world)) == Approx(0.0).margin(1e-12));
}
