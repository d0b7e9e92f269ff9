// A run goes on from a restored snapshot to the same bits, whatever happened in between.
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/parallel.hpp"
#include "base/random.hpp"
#include "choreography/choreography.hpp"
#include "choreography/hands.hpp"
#include "edit/assemble.hpp"
#include "laws/library.hpp"
#include "measure/hits.hpp"
#include "measure/measure.hpp"
#include "snapshot/snapshot.hpp"
#include "step/step.hpp"
#include "support/cases.hpp"
#include "support/melt.hpp"

using namespace pantin;
using Catch::Contains;

namespace {

std::vector<std::uint64_t> hashes(World& world, int steps) {
  std::vector<std::uint64_t> list;
  for (int i = 0; i < steps; i++) {
    step(world);
    list.push_back(state_hash(world));
  }
  REQUIRE(world.failure == "");
  return list;
}

std::shared_ptr<const Law> law_of(const char* name, const std::map<std::string, double>& numbers,
                                  std::optional<double> cutoff = {}) {
  LawArguments arguments;
  arguments.numbers = numbers;
  arguments.cutoff = cutoff;
  return std::make_shared<const Law>(make_library_law(name, arguments)[0]);
}

/// Hands, drawn-in follows and a join at work.
void make_busy(World& world) {
  const cases::Chain chain = cases::add_chain(world, {.links = 12}),
                     other = cases::add_chain(world, {.links = 5, .start = vec(0, 0, 2)});
  const std::int32_t hand = add_hand(world, [](double time) { return vec(12 - 8 * time, 3 * time, 1); });
  grab(world, hand, chain.tails[8], 300.0);
  JoinDef join;
  join.time_constant = 0.2;
  add_join(world, chain.tails.back(), other.tails.back(), join);
}

/// Stiff springs that are solved, and soft ones that are not.
void make_springs(World& world) {
  const cases::Chain chain = cases::add_chain(world, {.links = 8});
  const std::shared_ptr<const Law> law = law_of("spring", {{"stiffness", 1e6}, {"length", 1.0}});
  ParticleId last;
  for (int i = 0; i < 6; i++) {
    ParticleDef bob;
    bob.at = vec(8 + i, 0, 0.5);
    const ParticleId particle = add_particle(world, bob);
    ConnectionDef tie;
    const ParticleId before = last ? last : world.points[chain.tails.back()].own;
    tie.ends = {{awake(world, before), zero3()}, {particle, zero3()}};
    add_connection(world, law, tie);
    last = particle;
  }
}

void make_melt(World& world) {
  const cases::Melt melt(6);
  world.settings.gravity = zero3();
  world.settings.step = 0.005;
  set_box(world, vec(melt.edge, melt.edge, melt.edge));
  FamilyDef def;
  def.name = "argon";
  const FamilyId family = add_family(world, def);
  for (std::size_t i = 0; i < melt.positions.size(); i++) {
    ParticleDef atom;
    atom.at = melt.positions[i];
    atom.velocity = melt.velocities[i];
    atom.family = family;
    add_particle(world, atom);
  }
  add_interaction(world, law_of("lennard_jones", {{"epsilon", 1.0}, {"sigma", 1.0}}, 2.5), family, family);
}

BodyId add_box(World& world, Vec3 at, Vec3 velocity) {
  ShapeDef box;
  box.geometry = BoxShape{vec(0.25, 0.1, 0.1)};
  BodyDef body;
  body.shapes = {box};
  body.at = at;
  body.velocity = velocity;
  return add_body(world, body);
}

/// Boxes that push others into what they would not have met by themselves.
void make_pushed(World& world) {
  ShapeDef floor;
  floor.geometry = HalfSpaceShape{};
  floor.orientation = {std::sqrt(0.5), -std::sqrt(0.5), 0, 0};
  add_shape(world, floor);
  Random random{5};
  for (int i = 0; i < 30; i++)
    add_box(world, vec(0.6 * (i % 6), 0.15 + 0.3 * (i / 6), 0.0),
            vec(40 * random.uniform() - 20, 40 * random.uniform() - 20, 4 * random.uniform() - 2));
}

struct Case {
  std::string name;
  std::function<void(World&)> make;
};

std::vector<Case> all_cases() {
  return {
      {"chain", [](World& world) { cases::add_chain(world, {.links = 31}); }},
      {"heavy", [](World& world) { cases::add_heavy_chain(world, 10, 1e6); }},
      {"ring", [](World& world) { cases::add_ring(world, 24); }},
      {"wheel", [](World& world) { cases::add_wheel(world); }},
      {"top", [](World& world) { cases::add_top(world); }},
      {"double pendulum", [](World& world) { cases::add_double_pendulum(world); }},
      {"busy", make_busy},
      {"springs", make_springs},
      {"melt", make_melt},
      {"pushed", make_pushed},
      {"accuracy",
       [](World& world) {
         cases::add_chain(world);
         set_accuracy(world, 1e-3);
       }},
      {"ledger",
       [](World& world) {
         cases::add_chain(world);
         keep_ledger(world);
       }},
  };
}

/// Takes things apart and makes others.
void wreck(World& world) {
  const std::vector<BodyId> bodies = world.bodies.ids();
  for (std::size_t i = 0; i < bodies.size(); i += 3) remove(world, bodies[i]);
  for (int i = 0; i < 20; i++) {
    BodyDef body;
    body.mass = 1.0;
    body.inertia = diagonal(vec(1, 1, 1));
    body.at = vec(i, 1, 0);
    add_body(world, body);
  }
  for (ConnectionId id : world.connections.ids())
    if (!world.connections[id].parameters.empty()) set_parameter(world, id, 0, 10.0);
  set_gravity(world, vec(3, 1, 0));
}

}  // namespace

TEST_CASE("snapshot: after a restore the run goes on to the same bits") {
  for (const int threads : {1, 2})
    for (const Case& c : all_cases()) {
      CAPTURE(c.name, threads);
      World world;
      world.workers = std::make_unique<Workers>(threads);
      c.make(world);
      hashes(world, 60);
      const Snapshot snapshot = take_snapshot(world);
      const std::vector<std::uint64_t> first = hashes(world, 60);
      restore(world, snapshot);
      CHECK(world.steps == 60);
      CHECK(hashes(world, 60) == first);
      restore(world, snapshot);
      wreck(world);
      hashes(world, 10);
      restore(world, snapshot);
      CHECK(hashes(world, 60) == first);
    }
}

TEST_CASE("snapshot: taking one changes no bit of the run") {
  for (const Case& c : all_cases()) {
    CAPTURE(c.name);
    World with, without;
    c.make(with);
    c.make(without);
    bool same = true;
    for (int i = 0; i < 60; i++) {
      if (i % 7 == 0) take_snapshot(with);
      step(with);
      step(without);
      same = same && state_hash(with) == state_hash(without);
    }
    CHECK(same);
    CHECK(with.work == without.work);
    CHECK(with.stats.newton_iterations == without.stats.newton_iterations);
  }
}

TEST_CASE("snapshot: an edit that still waits for its step is part of it") {
  World world;
  const cases::Chain chain = cases::add_chain(world);
  hashes(world, 20);
  cut(world, chain.hinges[4]);
  const Snapshot snapshot = take_snapshot(world);
  const std::vector<std::uint64_t> first = hashes(world, 40);
  restore(world, snapshot);
  CHECK(hashes(world, 40) == first);
}

TEST_CASE("snapshot: shapes that wait for their first step are part of it") {
  World world;
  make_pushed(world);
  hashes(world, 20);
  for (int i = 0; i < 50; i++) add_box(world, vec(0.3 * i, 3.0, 0.1 * i), zero3());
  remove(world, world.bodies.ids()[2]);
  const Snapshot snapshot = take_snapshot(world);
  const std::vector<std::uint64_t> first = hashes(world, 40);
  restore(world, snapshot);
  CHECK(hashes(world, 40) == first);
}

TEST_CASE("snapshot: shapes made, moved and removed since then meet nothing once it is restored") {
  World world;
  make_pushed(world);
  hashes(world, 20);
  const Snapshot snapshot = take_snapshot(world);
  const std::vector<std::uint64_t> first = hashes(world, 40);
  restore(world, snapshot);
  for (int i = 0; i < 50; i++) add_box(world, vec(0.6 * i, 0.15, 0.0), vec(-30, 0, 0));
  remove(world, world.bodies.ids()[2]);
  hashes(world, 20);
  restore(world, snapshot);
  for (const Hit& hit : hits_of_ray(world, vec(100, 0.15, 0), vec(-100, 0.15, 0))) CHECK(world.shapes.alive(hit.shape));
  CHECK(hits_of_ray(world, vec(100, 3, 0), vec(20, 3, 0)).empty());
  CHECK(hashes(world, 40) == first);
}

TEST_CASE("snapshot: what was removed lives again, what was made is dead for ever and says so") {
  World world;
  const cases::Chain chain = cases::add_chain(world);
  hashes(world, 5);
  const Snapshot snapshot = take_snapshot(world);
  remove(world, chain.bodies[9]);
  BodyDef def;
  def.mass = 1.0;
  def.inertia = diagonal(vec(1, 1, 1));
  def.name = "late";
  const BodyId late = add_body(world, def), later = add_body(world, def);
  CHECK_FALSE(world.bodies.alive(chain.bodies[9]));
  restore(world, snapshot);
  CHECK(world.bodies.alive(chain.bodies[9]));
  CHECK(world.points.alive(chain.tails[9]));
  for (const BodyId id : {late, later}) {
    CHECK_FALSE(world.bodies.alive(id));
    CHECK_THAT(world.bodies.story(id), Contains("made after the moment that was restored"));
  }
  remove(world, chain.bodies[9]);
  const BodyId again = add_body(world, def);
  CHECK(again.slot == late.slot);
  CHECK(again != late);
  CHECK_FALSE(world.bodies.alive(late));
}

TEST_CASE("snapshot: events that fired since wait again, those added since are cancelled") {
  World world;
  int fired = 0;
  Event event;
  event.time = 0.1;
  event.action = [&] { fired++; };
  const EventId id = add_event(world, event);
  const std::shared_ptr<EventState> state = world.choreography.events[id].state;
  const Snapshot snapshot = take_snapshot(world);
  event.time = 0.5;
  const std::shared_ptr<EventState> other = world.choreography.events[add_event(world, event)].state;
  advance(world, 0.2);
  CHECK(*state == EventState::fired);
  restore(world, snapshot);
  CHECK(*state == EventState::waiting);
  CHECK(*other == EventState::cancelled);
  CHECK(world.choreography.past.empty());
  advance(world, 1.0);
  CHECK(*state == EventState::fired);
  CHECK(fired == 2);
}

TEST_CASE("snapshot: a play cannot be wound back") {
  World world;
  const Snapshot before = take_snapshot(world);
  Event play;
  play.kind = EventKind::play;
  play.label = "scene.lua:3";
  play.goes = [] { return Wait{0.1, {}}; };
  const EventId id = add_event(world, play);
  advance(world, 0.05);
  CHECK_THAT(why_not_restore(world), Contains("the scene's script waits (scene.lua:3)"));
  CHECK_THROWS_WITH(restore(world, before), Contains("cannot be wound back"));
  const Snapshot during = take_snapshot(world);
  cancel(world, id);
  CHECK(why_not_restore(world).empty());
  CHECK_THROWS_WITH(restore(world, during), Contains("waited at 0.05"));
  CHECK_NOTHROW(restore(world, before));
}

TEST_CASE("snapshot: a world that failed goes on from before") {
  World world;
  const cases::Chain chain = cases::add_chain(world);
  hashes(world, 5);
  const Snapshot snapshot = take_snapshot(world);
  const std::vector<std::uint64_t> first = hashes(world, 5);
  restore(world, snapshot);
  FollowDef follow;
  follow.target = [](double) { return vec(0, 1e300, 0); };
  add_follow(world, chain.tails.back(), follow);
  for (int i = 0; i < 200 && world.failure.empty(); i++) step(world);
  restore(world, snapshot);
  CHECK(hashes(world, 5) == first);
}

TEST_CASE("snapshot: one of another world, or an empty one, is refused, and the world goes on as it would have") {
  World world, other;
  cases::add_chain(world, {.links = 5});
  cases::add_chain(other, {.links = 5});
  hashes(world, 3);
  const Snapshot here = take_snapshot(world);
  const std::vector<std::uint64_t> first = hashes(world, 5);
  restore(world, here);
  const Snapshot nothing, there = take_snapshot(other);
  CHECK(why_not_restore(world, there) == "the snapshot is of another world");
  CHECK_THROWS_WITH(restore(world, there), "restore: the snapshot is of another world");
  CHECK_THROWS_WITH(restore(world, nothing), "restore: the snapshot is empty");
  CHECK_THROWS_WITH(nothing.time(), Contains("snapshot: it is empty"));
  CHECK_THROWS_WITH(nothing.steps(), Contains("snapshot: it is empty"));
  CHECK(hashes(world, 5) == first);
}

TEST_CASE("snapshot: within a step one may be taken, where scripts run, but none restored") {
  World world;
  const cases::Chain chain = cases::add_chain(world, {.links = 5});
  const Snapshot before = take_snapshot(world);
  std::optional<Snapshot> within;
  world.behaviours = [&] {
    within = take_snapshot(world);
    CHECK_THROWS_WITH(restore(world, before), "restore: a step is under way; restore between two steps");
  };
  step(world);
  world.behaviours = nullptr;
  CHECK(world.steps == 1);
  restore(world, within.value());
  FollowDef follow;
  follow.max_force = 10;
  follow.target = [&](double) {
    CHECK_THROWS_WITH(take_snapshot(world), Contains("snapshot: none can be taken while the world steps"));
    return vec(5, 0, 0);
  };
  add_follow(world, chain.tails.back(), follow);
  step(world);
}
