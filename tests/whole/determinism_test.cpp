// The same bits: twice in one process, and against hashes on record, which every compiler and build type must meet.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "base/parallel.hpp"
#include "choreography/hands.hpp"
#include "measure/measure.hpp"
#include "step/step.hpp"
#include "support/cases.hpp"
#include "support/sources.hpp"
#include "support/watch.hpp"

using namespace pantin;

namespace {

struct Case {
  std::string name;
  std::function<void(World&)> make;
};

void make_pulled(World& world) {
  const cases::Chain chain = cases::add_chain(world);
  FollowDef follow;
  follow.target = [](double time) { return vec(10 + (time < 0.5 ? 5 * time : 2 - 5 * (time - 0.5)), 0, 0); };
  add_follow(world, chain.tails.back(), follow);
}

void make_held(World& world) {
  const cases::Chain chain = cases::add_chain(world, {.links = 31});
  const std::int32_t hand = add_hand(world, [](double time) { return vec(20 - 10 * time, 5 * time, 3); });
  grab(world, hand, chain.tails[15], 500.0);
}

/// A wheel of chains on a nail, moved by its tree.
void make_tree_of_hinges(World& world) {
  world.settings.integrator = Integrator::adaptive;
  const cases::Wheel wheel = cases::add_wheel(world, {.spokes = 5, .links = 3});
  add_nail(world, wheel.centre);
}

/// Articulates of many sizes, spinning bodies and falling particles: enough for several threads.
void make_crowd(World& world) {
  for (int i = 0; i < 30; i++) cases::add_chain(world, {.links = 1 + i, .start = vec(0, 0, i)});
  cases::add_ring(world, 24);
  for (int i = 0; i < 200; i++) {
    BodyDef top;
    top.at = vec(i, 10, 0);
    top.mass = 1.0;
    top.inertia = diagonal(vec(1, 2, 3));
    top.spin = vec(0.1 * i, 1, 0.01);
    add_body(world, top);
  }
  for (int i = 0; i < 9000; i++) {
    ParticleDef drop;
    drop.at = vec(i, 20, 0);
    drop.velocity = vec(0, 0.01 * i, 0);
    add_particle(world, drop);
  }
}

std::vector<Case> all_cases() {
  return {
      {"chain", [](World& world) { cases::add_chain(world, {.links = 31}); }},
      {"heavy", [](World& world) { cases::add_heavy_chain(world, 10, 1e6); }},
      {"ring", [](World& world) { cases::add_ring(world, 24); }},
      {"top", [](World& world) { cases::add_top(world); }},
      {"double_pendulum", [](World& world) { cases::add_double_pendulum(world); }},
      {"pulled", make_pulled},
      {"held", make_held},
      {"tree", make_tree_of_hinges},
  };
}

std::string hash_after_one_second(const Case& c) {
  World world;
  c.make(world);
  advance(world, 1.0);
  REQUIRE(world.failure == "");
  return std::to_string(state_hash(world));
}

const std::string record = sources::folder() + "/tests/golden/state_hashes.txt";

}  // namespace

TEST_CASE("determinism: two runs in one process have the same bits after every step") {
  for (const Case& c : all_cases()) {
    CAPTURE(c.name);
    World first, second;
    c.make(first);
    c.make(second);
    CHECK(state_hash(first) == state_hash(second));
    bool same = true;
    for (int i = 0; i < 240; i++) {
      step(first);
      step(second);
      same = same && state_hash(first) == state_hash(second);
    }
    CHECK(same);
  }
}

TEST_CASE("determinism: the same bits for any number of threads") {
  const auto hashes = [](int threads) {
    World world;
    world.workers = std::make_unique<Workers>(threads);
    make_crowd(world);
    std::vector<std::uint64_t> list;
    for (int i = 0; i < 20; i++) {
      step(world);
      list.push_back(state_hash(world));
    }
    CHECK(world.failure == "");
    CHECK(world.stats.newton_iterations > 0);
    return list;
  };
  const std::vector<std::uint64_t> alone = hashes(1);
  CHECK(hashes(2) == alone);
  CHECK(hashes(4) == alone);
}

TEST_CASE("determinism: the hash sees one bit of one row") {
  World first, second;
  const cases::Chain a = cases::add_chain(first), b = cases::add_chain(second);
  const Vec3 v = vec(1, 0, 0);
  set_velocity(first, a.bodies[9], v);
  set_velocity(second, b.bodies[9], v * (1 + 2.3e-16));
  CHECK(state_hash(first) != state_hash(second));
}

// With the environment variable PANTIN_RECORD set, writes the record anew: for changes that are meant to change bits.
TEST_CASE("determinism: every build has the bits on record") {
  std::map<std::string, std::string> now;
  for (const Case& c : all_cases()) now[c.name] = hash_after_one_second(c);
  if (std::getenv("PANTIN_RECORD")) {
    std::ofstream out(record);
    for (const auto& [name, hash] : now) out << name << " " << hash << "\n";
  }
  std::map<std::string, std::string> recorded;
  std::ifstream in(record);
  REQUIRE(in);
  for (std::string name, hash; in >> name >> hash;) recorded[name] = hash;
  CHECK(recorded.size() == now.size());
  for (const auto& [name, hash] : now) {
    CAPTURE(name);
    CHECK(recorded[name] == hash);
  }
}
