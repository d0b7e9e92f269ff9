// Gaps too small to be an error, which no motion can close, are taken as constant offsets, and told as what they are.
#include <catch2/catch.hpp>

#include "edit/edit.hpp"
#include "measure/measure.hpp"
#include "step/step.hpp"
#include "support/cases.hpp"

using namespace pantin;

namespace {

PointId nailed_particle(World& world, Vec3 at) {
  ParticleDef def;
  def.at = at;
  const PointId point = world.particles[add_particle(world, def)].points.front();
  add_nail(world, point);
  return point;
}

void check_settled(const World& world, double gap) {
  REQUIRE(world.failure == "");
  CHECK(world.stats.fallback_steps == 1);
  CHECK(world.error.hinge_gap == Approx(gap).epsilon(1e-6));
  CHECK(accuracy(world).hinge_gap == Approx(world.error.hinge_gap).epsilon(1e-6));
  CHECK(accuracy(world).constraint == Approx(world.error.constraint).epsilon(1e-6));
}

}  // namespace

TEST_CASE("accepted gaps: a body between nails a little too far apart shares the gap, and both measures see it") {
  World world;
  const cases::Chain chain = cases::add_chain(world, {.links = 1});
  add_nail(world, chain.tails[0], vec(1 + 2e-7, 0, 0));
  advance(world, 0.25);
  check_settled(world, 1e-7);
}

TEST_CASE("accepted gaps: a rod a little too long between nails takes half of it, as both its ends give way") {
  World world;
  const PointId a = nailed_particle(world, vec(0, 0, 0)), b = nailed_particle(world, vec(1, 0, 0));
  add_rod(world, a, b, 1 + 4e-7);
  advance(world, 0.25);
  check_settled(world, 1e-7);
  CHECK(accuracy(world).constraint == Approx(2e-7).epsilon(1e-6));
}
