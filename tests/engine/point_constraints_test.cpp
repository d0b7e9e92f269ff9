#include "edit/constrain.hpp"

#include <catch2/catch.hpp>

#include "support/rods.hpp"

using namespace pantin;
using namespace pantin::test;
using Catch::Contains;

namespace {
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
}

TEST_CASE("a nail holds a point where it is, or draws it in") {
  World world;
  const BodyId body = add_body(world, rod_at(zero3()));
  set_velocity(world, body, vec(0, 1, 0));
  const ConstraintId here = add_nail(world, left_of(world, body));
  CHECK(same(world.constraints[here].attract.away, zero3()));
  const ConstraintId there = add_nail(world, right_of(world, body), vec(1, 2, 0));
  CHECK(norm(world.constraints[there].attract.away - vec(0, -2, 0)) < 1e-14);
  CHECK(norm(world.constraints[there].attract.away_rate - vec(0, 1, 0)) < 1e-14);
  CHECK_THROWS_WITH(add_nail(world, left_of(world, body)), Contains("is already nailed"));
  CHECK_THROWS_WITH(add_follow(world, left_of(world, body), {}), Contains("is already nailed"));
  CHECK_THROWS_WITH(add_nail(world, left_of(world, body), vec(0, 0, not_a_number)),
                    Contains("nail: at must be finite"));
}

TEST_CASE("a target cannot edit, not even when it is asked for the first time") {
  Two t;
  const PointId point = left_of(t.world, t.a);
  const auto meddling = [&](double) {
    add_particle(t.world, {});
    return zero3();
  };
  FollowDef def;
  def.target = meddling;
  CHECK_THROWS_WITH(add_follow(t.world, point, def), Contains("cannot be edited"));
  CHECK(t.world.constraints.empty());
  def.target = [](double) { return zero3(); };
  const ConstraintId follow = add_follow(t.world, point, def);
  CHECK_THROWS_WITH(set_target(t.world, follow, meddling), Contains("cannot be edited"));
  CHECK(same(t.world.constraints[follow].position.of_time(0.0), zero3()));
  CHECK_FALSE(t.world.locked);
}

TEST_CASE("two nailed rings do not join") {
  World world;
  const BodyId a = add_body(world, rod_at(zero3())), b = add_body(world, rod_at(zero3()));
  add_nail(world, left_of(world, a));
  add_nail(world, left_of(world, b));
  CHECK_THROWS_WITH(join(world, {left_of(world, a), left_of(world, b)}), Contains("held twice"));
}

TEST_CASE("a rod keeps the present distance; ends in one body or position are errors") {
  Two t;
  const PointId al = left_of(t.world, t.a), ar = right_of(t.world, t.a), br = right_of(t.world, t.b);
  const ConstraintId rod = add_rod(t.world, al, br);
  CHECK(t.world.constraints[rod].number.now == 2.0);
  CHECK_THROWS_WITH(add_rod(t.world, al, ar), Contains("both ends belong to body 'a'"));
  CHECK_THROWS_WITH(add_rod(t.world, ar, left_of(t.world, t.b)), Contains("its ends are one particle"));
  CHECK_THROWS_WITH(add_rod(t.world, al, br, 3.0), Contains("2 m apart") && Contains("3 m"));
  CHECK_THROWS_WITH(add_rod(t.world, al, zero3()), Contains("length must be > 0 m"));
  set_length(t.world, rod, 1.5);
  CHECK(t.world.constraints[rod].number.now == 1.5);
  CHECK_THROWS_WITH(set_length(t.world, rod, 0), Contains("length must be > 0 m"));
  CHECK_THROWS_WITH(set_length(t.world, add_nail(t.world, al), 1), Contains("has none"));
}
