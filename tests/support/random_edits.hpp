#pragma once
#include <catch2/catch.hpp>
#include <memory>
#include <vector>

#include "choreography/bonding.hpp"
#include "edit/assemble.hpp"
#include "edit/constrain.hpp"
#include "laws/library.hpp"
#include "measure/query.hpp"
#include "step/step.hpp"
#include "support/balance.hpp"

namespace pantin {

/// Edits of all kinds on a running scene, in an order that is always the same.
struct RandomEdits {
  World world;
  BodyMaker make;
  std::vector<BodyId> dead_bodies;
  std::vector<ParticleId> dead_hinges;
  int refused = 0, merges = 0, splits = 0, cuts = 0, joins = 0, welds = 0, freezes = 0, shatters = 0, ties = 0;
  std::shared_ptr<const Law> spring = [] {
    LawArguments arguments;
    arguments.numbers = {{"stiffness", 1.0}, {"length", 1.0}};
    return std::make_shared<const Law>(make_library_law("spring", arguments).front());
  }();
  FamilyId dust = [this] {
    FamilyDef def;
    def.name = "dust";
    return add_family(world, def);
  }();

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
    expect_balances_kept(world, [&] { merge(world, a, b); });
    dead_bodies.push_back(b);
    merges++;
  }

  void split_one() {
    const BodyId body = some_body();
    std::vector<PointId> some;
    for (PointId p : world.bodies[body].points)
      if (make.random.uniform() < 0.4) some.push_back(p);
    if (some.empty() || some.size() == world.bodies[body].points.size()) return;
    expect_balances_kept(world, [&] { split(world, body, some); });
    splits++;
  }

  void cut_one() {
    const std::vector<ParticleId> all = hinges(world);
    if (all.empty()) return;
    const ParticleId hinge = all[below(all.size())];
    expect_balances_kept(world, [&] { cut(world, hinge); });
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

  void weld_two() {
    const BodyId a = some_body(), b = some_body();
    if (a == b) return;
    expect_balances_kept(world, [&] { add_weld(world, a, b); });
    welds++;
  }

  void connect_two() {
    const ParticleId a = world.points[some_point(some_body())].particle,
                     b = world.points[some_point(some_body())].particle;
    if (a == b) return;
    ConnectionDef def;
    def.ends = {{a, zero3()}, {b, zero3()}};
    add_connection(world, spring, def);
    ties++;
  }

  void connect_near() {
    const GroupId group = add_group(world, "near");
    for (int i = 0; i < 3; i++) add_to_group(world, group, some_body());
    for (const auto& [a, b] : pairs_within(world, group, 2.0)) {
      ConnectionDef def;
      def.ends = {{a, zero3()}, {b, zero3()}};
      add_connection(world, spring, def);
    }
    remove(world, group);
  }

  void break_one() {
    const std::vector<ConnectionId> all = world.connections.ids();
    if (!all.empty()) remove(world, all[below(all.size())]);
  }

  void shatter_one() {
    const BodyId body = some_body();
    if (world.bodies[body].points.size() > 8) return;
    std::vector<ParticleId> pieces;
    expect_balances_kept(world, [&] { pieces = shatter(world, body); });
    dead_bodies.push_back(body);
    for (ParticleId piece : pieces)
      if (world.points[world.particles[piece].points[0]].particle == piece) set_family(world, piece, dust);
    shatters++;
  }

  /// Some of the dust becomes a body, at times with a body.
  void freeze_some() {
    std::vector<ParticleId> free;
    for (ParticleId id : particles(world, dust))
      if (!world.particles[id].is_hinge() && !world.points[world.particles[id].points[0]].body) free.push_back(id);
    if (free.size() < 3) return;
    const GroupId group = add_group(world, "dust");
    for (std::size_t i = 0; i < 3; i++) add_to_group(world, group, free[i * free.size() / 3]);
    if (below(4) == 0) {
      const BodyId body = some_body();
      add_to_group(world, group, body);
      dead_bodies.push_back(body);
    }
    expect_balances_kept(world, [&] { freeze(world, group); });
    remove(world, group);
    freezes++;
  }

  void edit() {
    try {
      switch (below(13)) {
        case 7: return weld_two();
        case 8: return connect_two();
        case 9: return connect_near();
        case 10: return break_one();
        case 11: return shatter_one();
        case 12: return freeze_some();
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

}  // namespace pantin
