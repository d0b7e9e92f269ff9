// Round shapes that are cut, and what ties a body that becomes several.
#include <algorithm>
#include <catch2/catch.hpp>

#include "edit/assemble.hpp"
#include "edit/constrain.hpp"
#include "step/step.hpp"
#include "support/balance.hpp"
#include "support/thrown.hpp"

using namespace pantin;
using Catch::Contains;

TEST_CASE("What is round is cut and shatters into hulls of its mass, and momenta are kept") {
  const Geometry round[] = {BallShape{0.5}, CapsuleShape{0.3, 0.4}, CylinderShape{0.4, 0.3}, CylinderShape{0.05, 1.0}};
  for (const Geometry& geometry : round)
    for (const bool breaks : {false, true}) {
      Weightless world;
      const BodyId body = add_body(world, thrown({thrown_shape(geometry)}));
      const double joules = kinetic(world);
      expect_balances_kept(world, [&] {
        if (breaks)
          shatter(world, body, {12, 3, {}});
        else
          split(world, body, origin(world, body) + vec(0.02, 0.01, 0.01), vec(1, 2, 0.5));
      });
      CHECK(world.bodies.size() == (breaks ? 12 : 2));
      CHECK(kinetic(world) == Approx(joules).epsilon(5e-3));
      CHECK(overlap_of(world) < 1e-13);
      for (const ShapeId id : world.shapes.ids()) CHECK(world.shapes[id].material.density < 1.04 * 1000.0);
      for (int i = 0; i < 20; i++) step(world);
      CHECK(world.failure.empty());
    }
}

TEST_CASE(
    "Halving a ball that only spins changes its kinetic energy by 2.3 %, as its moments do, and the ledger has it") {
  Weightless world;
  keep_ledger(world);
  BodyDef def = thrown({thrown_shape(BallShape{0.5})});
  def.velocity = zero3();
  const BodyId ball = add_body(world, def);
  step(world);
  const double joules = kinetic(world);
  split(world, ball, origin(world, ball), direction(def.spin + vec(0, 0, 1)));
  const double more = kinetic(world) - joules;
  CHECK(more > 0.0);
  CHECK(more < 0.024 * joules);
  CHECK(world.ledger.given[static_cast<std::size_t>(Source::edit)] == Approx(more).epsilon(1e-9));
}

TEST_CASE("A cylinder cut across is two cylinders, with the moments of such") {
  Weightless world;
  const BodyId body = add_body(world, thrown({thrown_shape(CylinderShape{0.3, 1.0})}));
  const Vec3 axis = rotate(orientation(world, body), vec(0, 0, 1));
  const double joules = kinetic(world), mass = world.motion_of(body).mass;
  BodyId front;
  expect_kept(world, [&] { front = split(world, body, origin(world, body) + axis * 0.5, axis); });
  CHECK(kinetic(world) == Approx(joules).epsilon(1e-13));
  CHECK(world.motion_of(front).mass == Approx(0.25 * mass).epsilon(1e-13));
  const Vec3 moments = vec(0.25 * 0.09 + 0.25 / 12.0, 0.25 * 0.09 + 0.25 / 12.0, 0.5 * 0.09) * (0.25 * mass);
  CHECK(norm(sorted(world.bodies[front].moments) - sorted(moments)) < 1e-12 * mass);
}

TEST_CASE("Welds and motors go with the part that has their anchor; what no part has ends, and the log says so") {
  Weightless world;
  BodyDef def = thrown({thrown_shape(box(4, 1, 1))});
  def.spin = zero3();
  def.velocity = zero3();
  def.points = {point(vec(2, 0, 0))};
  const BodyId plank = add_body(world, def);
  const auto at = [&](double x) { return def.at + rotate(def.orientation, vec(x, 0, 0)); };
  BodyDef cube = def;
  cube.shapes = {thrown_shape(box(1, 1, 1))};
  cube.points = {point(vec(-0.5, 0, 0))};
  cube.at = at(2.5);
  const BodyId wheel = add_body(world, cube);
  cube.at = at(-2.5);
  const BodyId lump = add_body(world, cube);
  const ParticleId hinge = add_hinge(world, std::vector{world.bodies[plank].points[0], world.bodies[wheel].points[0]});
  MotorDef turning;
  turning.axis = vec(1, 0, 0);
  turning.speed = 1.0;
  const ConstraintId motor = add_motor(world, wheel, plank, turning), weld = add_weld(world, plank, lump),
                     against_world = add_motor(world, plank, {}, turning);
  CHECK(world.particles.alive(hinge));
  SECTION("cut") {
    const BodyId front = split(world, plank, at(0), rotate(def.orientation, vec(1, 0, 0)));
    CHECK(world.constraints[motor].body_b == front);
    CHECK(world.constraints[weld].body_a == plank);
    CHECK(world.constraints[against_world].body_a == plank);
  }
  SECTION("shattered") {
    const std::vector<BodyId> pieces = shatter(world, plank, {8, 1, {}});
    const auto mean_x = [&](BodyId id) {
      return dot(world.motion_of(id).x - at(0), rotate(def.orientation, vec(1, 0, 0)));
    };
    CHECK(mean_x(world.constraints[motor].body_b) > 0.5);
    CHECK(std::find(pieces.begin(), pieces.end(), world.constraints[weld].body_a) != pieces.end());
    CHECK(!world.constraints.alive(against_world));
    CHECK_THAT(world.log.back().text, Contains("ended: none of the parts of body"));
  }
  for (int i = 0; i < 20; i++) step(world);
  CHECK(world.failure.empty());
}
