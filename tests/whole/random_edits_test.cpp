#include <catch2/catch.hpp>

#include "choreography/choreography.hpp"
#include "support/random_edits.hpp"
#include "support/watch.hpp"

using namespace pantin;
using Catch::Contains;

TEST_CASE("ten thousand random edits of five hundred running bodies keep the balances and leave nothing behind") {
  RandomEdits t;
  t.world.settings.gravity = zero3();
  while (t.world.bodies.size() < 500) t.add();
  BondingDef bonding;
  bonding.families = {t.dust};
  bonding.near = 1.0;
  bonding.below = bonding.above = 3.0;
  bonding.law = t.spring;
  const EventId bonds = add_bonding(t.world, bonding);
  for (int i = 0; i < 10'000; i++) {
    t.edit();
    while (t.world.bodies.size() < 480) t.add();
    if (i % 20 == 0) step(t.world);
    REQUIRE(t.world.failure.empty());
  }
  for (int count : {t.merges, t.splits, t.cuts, t.joins, t.welds, t.freezes, t.shatters, t.ties}) CHECK(count > 200);
  CHECK(t.refused < 1500);
  CHECK(all_finite(t.world));

  std::size_t points = 0, members = 0;
  for (BodyId id : t.world.bodies.ids()) points += t.world.bodies[id].points.size();
  points += everything(t.world).free_points.size();
  CHECK(t.world.points.size() == points);
  const std::vector<ParticleId> joined = hinges(t.world);
  CHECK(t.world.particles.size() == points + joined.size());
  for (ParticleId id : joined)
    for (PointId p : t.world.particles[id].points) members += t.world.points.alive(p);
  CHECK(members >= 2 * joined.size());
  for (BodyId id : t.dead_bodies) CHECK_FALSE(t.world.bodies.alive(id));
  CHECK_THAT(t.world.bodies.story(t.dead_bodies.back()), Contains("was removed") || Contains("long ago"));
  CHECK_THROWS_WITH(t.world.particles[t.dead_hinges.back()], Contains("was removed") || Contains("long ago"));
  cancel(t.world, bonds);
  for (BodyId id : t.world.bodies.ids()) remove(t.world, id);
  for (PointId id : everything(t.world).free_points) remove(t.world, id);
  CHECK(t.world.connections.empty());
  CHECK(t.world.groups.empty());
  CHECK(t.world.points.empty());
  CHECK(t.world.particles.empty());
  CHECK(t.world.constraints.empty());
}
