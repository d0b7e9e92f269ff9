#include "measure/query.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "support/rods.hpp"

using namespace pantin;
using namespace pantin::test;
using Catch::Contains;

namespace {
ParticleId ball_at(World& world, double x, std::string name = "") {
  ParticleDef def;
  def.at = vec(x, 0, 0);
  def.name = std::move(name);
  return add_particle(world, def);
}
}  // namespace

TEST_CASE("find gives the oldest living thing of a name") {
  Two t;
  const ParticleId old = ball_at(t.world, 0, "same"), young = ball_at(t.world, 1, "same");
  CHECK(find(t.world, "a") == AnyId{t.a});
  CHECK(find(t.world, "same") == AnyId{old});
  remove(t.world, old);
  CHECK(find(t.world, "same") == AnyId{young});
  CHECK(find(t.world, "nobody") == AnyId{});
  CHECK(find(t.world, "") == AnyId{});
  const GroupId group = add_group(t.world, "all");
  CHECK(find(t.world, "all") == AnyId{group});
}

TEST_CASE("near gives particles within the radius, nearest first") {
  World world;
  const ParticleId c = ball_at(world, 3), a = ball_at(world, 1), b = ball_at(world, -2);
  CHECK(near(world, zero3(), 3) == std::vector<ParticleId>{a, b, c});
  CHECK(near(world, zero3(), 2.5) == std::vector<ParticleId>{a, b});
  CHECK(near(world, zero3(), 0).empty());
  set_box(world, vec(4, 4, 4));
  CHECK(near(world, zero3(), 1) == std::vector<ParticleId>{c, a});
  set_box(world, std::nullopt);
  CHECK_THROWS_WITH(near(world, zero3(), -1), Contains("radius must be >= 0 m"));
  CHECK_THROWS_WITH(near(world, vec(0, std::nan(""), 0), 1), Contains("at must be finite"));
}

TEST_CASE("particles are those awake, hinges those of several points") {
  Two t;
  CHECK(particles(t.world).size() == 3);
  CHECK(hinges(t.world) == std::vector<ParticleId>{t.hinge});
  CHECK(hinges_of(t.world, t.a) == std::vector<ParticleId>{t.hinge});
  cut(t.world, t.hinge);
  CHECK(particles(t.world).size() == 4);
  CHECK(hinges(t.world).empty());
  CHECK(hinges_of(t.world, t.a).empty());
}

TEST_CASE("a hinge's force is that on the body asked for") {
  Two t;
  t.world.points[right_of(t.world, t.a)].row_force = vec(1, 2, 3);
  t.world.points[left_of(t.world, t.b)].row_force = vec(-1, -2, -3);
  CHECK(same(hinge_force(t.world, t.hinge, t.a), vec(1, 2, 3)));
  CHECK(same(hinge_force(t.world, t.world.points[left_of(t.world, t.b)].own, t.b), vec(-1, -2, -3)));
  const BodyId other = add_body(t.world, rod_at(zero3(), "other"));
  CHECK_THROWS_WITH(hinge_force(t.world, t.hinge, other), Contains("body 'other' is not in hinge"));
}
