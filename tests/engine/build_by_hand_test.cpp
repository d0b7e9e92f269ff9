#include "choreography/build_by_hand.hpp"

#include <catch2/catch.hpp>

#include "choreography/commands.hpp"
#include "edit/edit.hpp"
#include "measure/measure.hpp"
#include "measure/query.hpp"
#include "step/step.hpp"

using namespace pantin;
using Catch::Contains;
using Kind = Command::Kind;

namespace {

Command making(MadeForm form, Vec3 at, std::vector<Vec3> points = {zero3()}) {
  Command c;
  c.kind = Kind::make;
  c.form = form;
  c.position = at;
  c.points = std::move(points);
  c.radius = 0.5;
  c.amount = form == MadeForm::wheel ? vec(0, 0, 0.1) : vec(0.5, 0.5, 0.5);
  return c;
}

BodyId make(World& world, const Command& c) {
  make_by_hand(world, c);
  return world.bodies.ids().back();
}

std::size_t points_of(const World& world, BodyId body) { return world.bodies[body].points.size(); }

}  // namespace

TEST_CASE("build by hand: what is made has the mass of its shape by the usual density") {
  World world;
  const double density = Material{}.density;
  CHECK(world.motion_of(make(world, making(MadeForm::box, zero3()))).mass == Approx(density));
  CHECK(world.motion_of(make(world, making(MadeForm::ball, vec(3, 0, 0)))).mass == Approx(density * M_PI / 6.0));
  CHECK(world.motion_of(make(world, making(MadeForm::wheel, vec(6, 0, 0)))).mass == Approx(density * M_PI * 0.05));
}

TEST_CASE("build by hand: things that are made one after the other differ in colour, and their shapes are seen in it") {
  World world;
  const auto color_of = [&](BodyId body) { return world.shapes[world.bodies[body].shapes[0]].color; };
  const Color first = color_of(make(world, making(MadeForm::box, zero3()))),
              second = color_of(make(world, making(MadeForm::box, vec(3, 0, 0)))), usual = ShapeDef{}.color;
  CHECK_FALSE(first == second);
  CHECK_FALSE(first == usual);
}

TEST_CASE("build by hand: a rod is hinged to the places on bodies that its ends are at") {
  World world;
  const BodyId left = make(world, making(MadeForm::box, zero3())),
               right = make(world, making(MadeForm::box, vec(4, 0, 0)));
  Command c = making(MadeForm::rod, vec(0.2, 0.1, 0), {zero3(), vec(3.6, 0, 0)});
  c.thing = left;
  c.other_thing = right;
  const BodyId rod = make(world, c);
  REQUIRE(hinges_of(world, rod).size() == 2);
  CHECK(norm(position(world, world.bodies[left].points[0]) - vec(0.2, 0.1, 0)) < 1e-15);
  CHECK(norm(position(world, world.bodies[right].points[0]) - vec(3.8, 0.1, 0)) < 1e-15);
}

TEST_CASE("build by hand: contradictions are borne: a rod nailed at both ends and pulled, a box within another") {
  World world;
  const auto send = [&](const Command& command) { carry_out(world, std::vector{command}); };
  const BodyId rod = make(world, making(MadeForm::rod, zero3(), {zero3(), vec(2, 0, 0)}));
  Command nail;
  nail.kind = Kind::nail;
  for (const PointId point : world.bodies[rod].points) {
    nail.point = point;
    send(nail);
  }
  Command pull;
  pull.kind = Kind::tie;
  pull.name = "rope";
  pull.point = world.bodies[rod].points[1];
  pull.points = {vec(5, 0, 0)};
  send(pull);
  make(world, making(MadeForm::box, vec(0, 5, 0)));
  make(world, making(MadeForm::box, vec(0, 5, 0)));
  for (int i = 0; i < 240; i++) step(world);
  CHECK(world.failure.empty());
  CHECK(norm(position(world, world.bodies[rod].points[0])) < 1e-6);
  for (const BodyId body : world.bodies.ids()) CHECK(finite(world.motion_of(body).x));
}

TEST_CASE("build by hand: what is made on a thing that is gone is told, and nothing is left") {
  World world;
  const BodyId box = make(world, making(MadeForm::box, zero3()));
  const PointId point = add_point(world, box, {});
  remove(world, box);
  for (const Kind kind : {Kind::tie, Kind::join, Kind::drive, Kind::nail}) {
    Command c = making(MadeForm::wheel, zero3());
    c.kind = kind;
    c.name = "rope";
    c.point = point;
    carry_out(world, std::vector{c});
    CHECK_THAT(world.log.back().text, Contains("by hand 1: "));
  }
  CHECK(world.log.size() == 4);
  CHECK(world.bodies.empty());
  CHECK(world.points.empty());
  CHECK(world.constraints.empty());
}

TEST_CASE("build by hand: what is refused changes no body, to the bit") {
  World world;
  Command hull = making(MadeForm::hull, vec(0.3, 0.2, 0.1),
                        {vec(-0.3, -0.31, -0.32), vec(0.4, -0.3, -0.3), vec(0, 0.5, -0.3), vec(0, 0, 0.41)});
  const BodyId body = make(world, hull);
  const std::uint64_t before = state_hash(world);
  Command c;
  c.kind = Kind::join;
  c.thing = c.other_thing = body;
  c.position = vec(0.31, 0.22, 0.1);
  c.points = {vec(0.2, 0.2, 0.1)};
  for (int i = 0; i < 20; i++) carry_out(world, std::vector{c});
  CHECK(world.log.size() == 20);
  CHECK(state_hash(world) == before);
}

TEST_CASE("build by hand: what is refused leaves nothing behind") {
  World world;
  const BodyId box = make(world, making(MadeForm::box, zero3()));
  CHECK_THROWS_WITH(
      make_by_hand(world, making(MadeForm::hull, vec(3, 0, 0), {zero3(), vec(1, 0, 0), vec(0, 1, 0), vec(1, 1, 0)})),
      Contains("plane"));
  CHECK(world.bodies.size() == 1);
  Command tie;
  tie.kind = Kind::tie;
  tie.name = "rod";
  tie.thing = tie.other_thing = box;
  tie.points = {vec(0.2, 0, 0)};
  CHECK_THROWS_AS(tie_by_hand(world, tie), Error);
  CHECK(points_of(world, box) == 0);
  tie.name = "glue";
  tie.other_thing = {};
  CHECK_THROWS_WITH(tie_by_hand(world, tie), Contains("there is no 'glue'"));
  CHECK(points_of(world, box) == 0);
}

TEST_CASE("build by hand: a spring swings what it holds three times a second about where gravity lets it hang") {
  World world;
  const BodyId box = make(world, making(MadeForm::box, zero3()));
  Command tie;
  tie.kind = Kind::tie;
  tie.name = "spring";
  tie.thing = box;
  tie.points = {vec(0, 2, 0)};
  tie_by_hand(world, tie);
  for (int i = 0; i < 2400; i++) step(world);
  const double rate = 6.0 * M_PI;
  CHECK(world.motion_of(box).x[1] == Approx(-9.81 / (rate * rate)).epsilon(1e-3));
}

TEST_CASE("build by hand: a motor turns a wheel against what it is hinged to, and nothing that is free") {
  World world;
  world.settings.gravity = zero3();
  const BodyId box = make(world, making(MadeForm::box, zero3()));
  Command c = making(MadeForm::wheel, vec(0.4, 0, 0));
  c.thing = box;
  const BodyId wheel = make(world, c), free = make(world, making(MadeForm::wheel, vec(9, 0, 0)));
  Command drive;
  drive.kind = Kind::drive;
  drive.amount = vec(0, 0, 3);
  drive.thing = free;
  CHECK_THROWS_WITH(drive_by_hand(world, drive), Contains("is hinged to nothing"));
  drive.thing = wheel;
  drive_by_hand(world, drive);
  drive_by_hand(world, drive);
  for (int i = 0; i < 480; i++) step(world);
  const auto spin = [&](BodyId body) { return angular_velocity(world.motion_of(body))[2]; };
  CHECK(spin(wheel) - spin(box) == Approx(3.0).epsilon(1e-6));
  drive.amount = zero3();
  const std::size_t ties = world.constraints.size();
  drive_by_hand(world, drive);
  CHECK(world.constraints.size() == ties - 1);
}
