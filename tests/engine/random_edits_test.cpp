#include <catch2/catch.hpp>

#include "step.hpp"
#include "support/balance.hpp"
#include "support/watch.hpp"
#include "world/assemble.hpp"
#include "world/query.hpp"

using namespace pantin;
using Catch::Contains;

namespace {

/// Ten thousand edits of a running scene.
struct RandomEdits {
  World world;
  BodyMaker make;
  std::vector<BodyId> dead_bodies;
  std::vector<ParticleId> dead_hinges;
  int refused = 0, merges = 0, splits = 0, cuts = 0, joins = 0;

  std::size_t below(std::size_t n) { return static_cast<std::size_t>(make.random.uniform() * static_cast<double>(n)); }
  BodyId some_body() {
    const std::vector<BodyId> all = world.bodies.ids();
    return all[below(all.size())];
  }
  PointId some_point(BodyId body) { return world.bodies[body].points[below(world.bodies[body].points.size())]; }

  BodyId add() {
    BodyDef def = make.body(3 + below(4));
    def.at = make.place(30.0);
    return add_body(world, def);
  }

  void merge_two() {
    const BodyId a = some_body(), b = some_body();
    if (a == b || world.bodies[a].points.size() + world.bodies[b].points.size() > 30) return;
    expect_kept(world, [&] { merge(world, a, b); });
    dead_bodies.push_back(b);
    merges++;
  }

  void split_one() {
    const BodyId body = some_body();
    std::vector<PointId> some;
    for (PointId p : world.bodies[body].points)
      if (make.random.uniform() < 0.4) some.push_back(p);
    if (some.empty() || some.size() == world.bodies[body].points.size()) return;
    expect_kept(world, [&] { split(world, body, some); });
    splits++;
  }

  void cut_one() {
    const std::vector<ParticleId> all = hinges(world);
    if (all.empty()) return;
    const ParticleId hinge = all[below(all.size())];
    expect_kept(world, [&] { cut(world, hinge); });
    dead_hinges.push_back(hinge);
    cuts++;
  }

  /// A point of one body gets a companion on another, so that both can be joined at once; or they are drawn together.
  void join_two() {
    const BodyId a = some_body(), b = some_body();
    if (a == b) return;
    const PointId first = some_point(a);
    if (below(4) == 0) {
      add_join(world, first, some_point(b));
    } else {
      PointDef def;
      def.at = rotate(conjugate(orientation(world, b)), position(world, first) - origin(world, b));
      def.mass = 0.1;
      const PointId points[] = {first, add_point(world, b, def)};
      add_hinge(world, points);
    }
    joins++;
  }

  void edit() {
    try {
      switch (below(7)) {
        case 0: return merge_two();
        case 1:
        case 2: return split_one();
        case 3: return cut_one();
        case 4: return join_two();
        case 5: return set_mass(world, some_point(some_body()), make.number(0.1, 2.0));
        default: {
          const BodyId body = some_body();
          remove(world, body);
          dead_bodies.push_back(body);
        }
      }
    } catch (const Error&) { refused++; }
  }
};

}  // namespace

TEST_CASE("ten thousand random edits of five hundred running bodies keep the balances and leave nothing behind") {
  RandomEdits t;
  t.world.settings.gravity = zero3();
  while (t.world.bodies.size() < 500) t.add();
  for (int i = 0; i < 10'000; i++) {
    t.edit();
    while (t.world.bodies.size() < 480) t.add();
    if (i % 20 == 0) step(t.world);
    REQUIRE(t.world.failure.empty());
  }
  CHECK(t.merges > 1000);
  CHECK(t.splits > 1000);
  CHECK(t.cuts > 200);
  CHECK(t.joins > 1000);
  CHECK(t.refused < 1000);
  CHECK(all_finite(t.world));

  std::size_t points = 0, members = 0;
  for (BodyId id : t.world.bodies.ids()) points += t.world.bodies[id].points.size();
  CHECK(t.world.points.size() == points);
  const std::vector<ParticleId> joined = hinges(t.world);
  CHECK(t.world.particles.size() == points + joined.size());
  for (ParticleId id : joined)
    for (PointId p : t.world.particles[id].points) members += t.world.points.alive(p);
  CHECK(members >= 2 * joined.size());
  for (BodyId id : t.dead_bodies) CHECK_FALSE(t.world.bodies.alive(id));
  CHECK_THAT(t.world.bodies.story(t.dead_bodies.back()), Contains("was removed") || Contains("long ago"));
  CHECK_THROWS_WITH(t.world.particles[t.dead_hinges.back()], Contains("was removed") || Contains("long ago"));
  for (BodyId id : t.world.bodies.ids()) remove(t.world, id);
  CHECK(t.world.points.empty());
  CHECK(t.world.particles.empty());
  CHECK(t.world.constraints.empty());
}
