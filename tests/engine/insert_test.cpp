// Constraints of any kind, made of what they tie and keep.
#include <catch2/catch.hpp>
#include <cmath>

#include "edit/constrain.hpp"
#include "support/cases.hpp"

using namespace pantin;
using Catch::Contains;

namespace {

PointId particle_at(World& world, Vec3 at) {
  ParticleDef def;
  def.at = at;
  return cases::point_of(world, add_particle(world, def));
}

Constraint of_point(ConstraintKind kind, PointId point) {
  Constraint c;
  c.kind = kind;
  c.a = point;
  return c;
}

}  // namespace

TEST_CASE("a constraint of any kind is checked when it is made") {
  World world;
  const PointId point = particle_at(world, zero3()), gone = particle_at(world, vec(1, 0, 0));
  remove(world, world.points[gone].particle);
  Constraint c = of_point(ConstraintKind::limit, gone);
  CHECK_THROWS_WITH(add_constraint(world, c), Contains("limit: ") && Contains("was removed"));
  c.a = {};
  CHECK_THROWS_WITH(add_constraint(world, c), Contains("limit: "));
  c.a = point;
  c.low = -1.0;
  CHECK_THROWS_WITH(add_constraint(world, c), Contains("limit: min must be >= 0 m, got -1"));
  c.low = 0.0;
  CHECK_THROWS_WITH(add_constraint(world, c), Contains("limit: min must be below max, got 0 and 0 m"));
  c.high = 2.0;
  c.time_constant = 0.0;
  CHECK_THROWS_WITH(add_constraint(world, c), Contains("limit: time_constant must be > 0 s"));
  c.time_constant = 0.1;
  c.position.now[1] = std::nan("");
  CHECK_THROWS_WITH(add_constraint(world, c), Contains("limit: position must be finite"));
  c = of_point(ConstraintKind::string, {});
  c.own = StringData{};
  CHECK_THROWS_WITH(add_constraint(world, c), Contains("string: needs two points or more, got 0"));
  c = of_point(ConstraintKind::rod, point);
  CHECK_THROWS_WITH(add_constraint(world, c), Contains("rod: length must be > 0 m"));
  add_constraint(world, of_point(ConstraintKind::nail, point));
  CHECK_THROWS_WITH(add_constraint(world, of_point(ConstraintKind::follow, point)), Contains("is already nailed"));
  CHECK(world.constraints.size() == 1);
}

TEST_CASE("a constraint whose points are in its own data alone is refused unless the first is its own") {
  World world;
  const PointId a = particle_at(world, zero3()), b = particle_at(world, vec(1, 0, 0)),
                other = particle_at(world, zero3());
  CoupledValue distance;
  distance.point_a = a;
  distance.point_b = b;
  Constraint pulley = of_point(ConstraintKind::pulley, {}), string = of_point(ConstraintKind::string, other);
  pulley.number.now = 1.0;
  pulley.own = CouplingData{{distance, distance}, 2.0};
  CHECK_THROWS_WITH(add_constraint(world, pulley), Contains("pulley: "));
  pulley.a = other;
  CHECK_THROWS_WITH(add_constraint(world, pulley), Contains("pulley: its first point is none of those that it ties"));
  string.number.now = 1.0;
  string.own = StringData{{{a}, {b}}};
  CHECK_THROWS_WITH(add_constraint(world, string), Contains("string: its first point is none of those that it ties"));
  pulley.a = a;
  string.a = b;
  add_constraint(world, pulley);
  add_constraint(world, string);
  CHECK(world.constraints.size() == 2);
}

TEST_CASE("a constraint that is changed to what it cannot be stays as it was") {
  World world;
  const ConstraintId plane = cases::add_on_plane(world, particle_at(world, zero3()), vec(0, 2, 0));
  const auto turn = [&](Vec3 normal) {
    change_constraint(world, plane, "normal", [&](Constraint& c) { c.axis_a = normal; });
  };
  CHECK_THROWS_WITH(turn(zero3()), Contains("on_plane: normal must not be vec(0, 0, 0)"));
  CHECK(same(world.constraints[plane].axis_a, vec(0, 1, 0)));
  turn(vec(0, 0, 3));
  CHECK(same(world.constraints[plane].axis_a, vec(0, 0, 1)));
  const ConstraintId nail = add_nail(world, particle_at(world, zero3()));
  change_constraint(world, nail, "at", [](Constraint& c) { c.position.now = vec(1, 0, 0); });
  CHECK(same(world.constraints[nail].attract.away, vec(-1, 0, 0)));
  const Lock lock(world);
  CHECK_THROWS_WITH(turn(vec(1, 0, 0)), Contains("normal: the world cannot be edited while it steps"));
}
