// Snapshots of scenes: those that ship, and what a script has of its own.
#include <algorithm>
#include <filesystem>

#include "bindings/lua_support.hpp"
#include "choreography/hands.hpp"
#include "lua/scene/open.hpp"
#include "measure/measure.hpp"
#include "support/allocations.hpp"

using namespace pantin;
using namespace pantin::lua_tests;
using Catch::Contains;
using Catch::StartsWith;

namespace {

void steps(Scene& scene, int count) {
  for (int i = 0; i < count; i++) scene.step();
  REQUIRE(scene.world().failure == "");
}

std::unique_ptr<Scene> shipped(const std::string& name, int threads = 1) {
  SceneOptions o = options();
  o.script_limit = 0.0;
  o.memory_limit = std::size_t{1} << 30;
  o.threads = threads;
  return lua::open_scene(sources::folder() + "/scripts/scenes/" + name, o);
}

std::vector<std::string> shipped_scenes() {
  std::vector<std::string> names;
  for (const auto& file : std::filesystem::directory_iterator(sources::folder() + "/scripts/scenes"))
    if (file.path().extension() == ".lua") names.push_back(file.path().filename());
  std::sort(names.begin(), names.end());
  return names;
}

/// Runs a scene for `count` steps, keeps it, runs on for as many, goes back, and runs on again.
void check_goes_on(Scene& scene, int count) {
  steps(scene, count);
  const auto snapshot = scene.take_snapshot();
  steps(scene, count);
  const std::uint64_t first = state_hash(scene.world());
  const std::string why = scene.why_not_restore();
  if (!why.empty()) {
    CHECK_THROWS_WITH(scene.restore(*snapshot), Contains(why));
    return;
  }
  scene.restore(*snapshot);
  steps(scene, count);
  CHECK(state_hash(scene.world()) == first);
}

}  // namespace

TEST_CASE("snapshot: every scene that ships goes on to the same bits") {
  for (const std::string& name : shipped_scenes()) {
    CAPTURE(name);
    check_goes_on(*shipped(name), 30);
  }
}

TEST_CASE("snapshot: every scene that ships goes on to the same bits, for a second", "[slow][shipped]") {
  for (const std::string& name : shipped_scenes()) {
    CAPTURE(name);
    const auto scene = shipped(name, 2);
    check_goes_on(*scene, static_cast<int>(1.0 / scene->world().settings.step));
  }
}

TEST_CASE("snapshot: scene.store and the data of things go back, and stay the same tables") {
  const auto scene = open(R"(
    local a = scene:particle{ name = "a" }
    scene.store = { count = 1, list = { 1, { 2 } }, at = vec(1, 2, 3), who = a }
    local list = scene.store.list
    a.data.hits, a.data.f = 1, function() return 5 end
    scene:at(0.1, function()
      scene.store.count, list[2][1], list[3], scene.store.at, a.data.hits = 2, 7, {}, nil, 9
      scene.store.store = scene.store
      a:remove()
    end)
    scene:button("look", function()
      scene:result("x", scene.store.count * 1000 + #list * 100 + list[2][1] * 10 + a.data.hits)
      assert(scene.store.at == vec(1, 2, 3) and scene.store.who == a and a.data.f() == 5 and list == scene.store.list)
      assert(scene.store.store == nil)
    end))");
  const auto snapshot = scene->take_snapshot();
  steps(*scene, 48);
  scene->restore(*snapshot);
  Command look;
  look.kind = Command::Kind::button;
  look.name = "look";
  scene->world().input.commands.push_back(look);
  steps(*scene, 1);
  CHECK(std::get<double>(scene->results().at("x")) == 1221.0);
}

TEST_CASE("snapshot: what is not plain in scene.store is told with its path") {
  CHECK(failure("scene.store.a = { b = { [3] = print } }\nscene:snapshot()") ==
        "scene.lua:2: scene.store.a.b[3] is a function, and only plain values can be kept: numbers, strings, true and "
        "false, vecs, quats, things of the scene and tables of these");
  CHECK_THAT(failure("scene.store[scene:at(1, print)] = 1 scene:snapshot()"), Contains("scene.store: a key is "));
  CHECK_THAT(failure("scene.store.m = setmetatable({}, {}) scene:snapshot()"), Contains("a table with a metatable"));
  CHECK_THAT(failure("local t = scene.store for i = 1, 1000 do t.t = {} t = t.t end scene:snapshot()"),
             Contains("nested more than 150 deep"));
}

TEST_CASE("snapshot: a script goes back when its step is done, with its handlers and behaviours as they were") {
  const auto scene = open(R"(
    local top = scene:particle{ name = "top", at = vec(0, 1, 0) }
    local saved, calls, late
    scene:on("step", function() calls = (calls or 0) + 1 end)
    scene:at(0.5, function() saved = scene:snapshot() end)
    scene:at(1, function()
      late = scene:particle{}
      scene:on("step", function() assert(scene.time > 0.9) end)
      scene:restore(saved)
      assert(scene.time > 0.9 and late.alive)
    end)
    scene:probe("now", function() return scene.time end)
    scene:on("key", function()
      scene:result("x", saved.time)
      assert(not late.alive and not pcall(function() return late.mass end))
    end))");
  steps(*scene, 241);
  CHECK(scene->world().time == 0.5);
  CHECK(scene->world().probes[0].values.size() == 120);
  Command key;
  key.name = "k";
  scene->world().input.commands.push_back(key);
  steps(*scene, 10);
  CHECK(std::get<double>(scene->results().at("x")) == 0.5);
}

TEST_CASE("snapshot: what is due when it is taken happens after it, again to the bit") {
  const auto scene = open(R"(
    scene.step = 0.1
    local ball, told = scene:particle {}, scene.store
    told.events = 0
    local function hit() told.events = told.events + 1 ball:kick(vec(0.1, 0, 0.3)) end
    scene:at(0.5, hit) scene:at(0.55, hit) scene:every(0.25, hit) scene:over(0.4, 0.9, hit)
    scene:when({ distance_above = 1, of = { ball, vec(0, 0, 0) } }, hit)
    scene:probe("events", function() return told.events end))");
  const auto events = [&] { return scene->world().probes[0].latest; };
  steps(*scene, 5);
  REQUIRE(scene->world().time == 0.5);
  REQUIRE(events() == 2);  // of every at 0.3, of over at 0.4
  const auto snapshot = scene->take_snapshot();
  const auto go_on = [&] {
    steps(*scene, 1);
    CHECK(events() == 6);  // at, every, over and when at 0.5
    steps(*scene, 9);
    return std::pair(state_hash(scene->world()), events());
  };
  const auto first = go_on();
  scene->restore(*snapshot);
  CHECK(go_on() == first);
}

TEST_CASE("snapshot: reset goes back to the start") {
  const auto scene = open(R"(
    local ball = scene:particle{ at = vec(0, 1, 0) }
    scene.store.tries = 0
    scene:button("again", function() scene:reset() end)
    scene:probe("y", function() return ball.position.y end))");
  Command again;
  again.kind = Command::Kind::button;
  again.name = "again";
  steps(*scene, 30);
  const std::uint64_t first = state_hash(scene->world());
  scene->world().input.commands.push_back(again);
  steps(*scene, 1);
  CHECK(scene->world().steps == 0);
  steps(*scene, 30);
  CHECK(state_hash(scene->world()) == first);
}

TEST_CASE("snapshot: data is kept however deep it is linked") {
  const auto scene = open(R"(
    local deep = scene:particle{}.data
    for i = 1, 20000 do deep.inner = { i = i } deep = deep.inner end
    scene:probe("i", function() return deep.i end)
    scene:at(0.1, function() deep.i = 0 end))");
  const auto snapshot = scene->take_snapshot();
  steps(*scene, 30);
  CHECK(scene->world().probes[0].latest == 0.0);
  scene->restore(*snapshot);
  steps(*scene, 1);
  CHECK(scene->world().probes[0].latest == 20000.0);
}

TEST_CASE("snapshot: reset tells why a start could not be kept") {
  CHECK_THAT(failure("scene.store.f = print scene:at(0.01, function() scene:reset() end)"),
             Contains("the start could not be kept: scene.store.f is a function"));
}

TEST_CASE("snapshot: parameters that changed are told their old value") {
  const auto scene = open(R"(
    local speed = scene:param("speed", 1, { on_change = function(v) speed_now = v end })
    speed_now = speed
    scene:probe("speed", function() return speed_now end))");
  const auto snapshot = scene->take_snapshot();
  CHECK(scene->set_parameter("speed", 5.0));
  steps(*scene, 1);
  CHECK(scene->world().probes[0].latest == 5.0);
  scene->restore(*snapshot);
  CHECK(std::get<double>(scene->parameters()[0].value) == 1.0);
  steps(*scene, 1);
  CHECK(scene->world().probes[0].latest == 1.0);
}

TEST_CASE("snapshot: misuse is told") {
  CHECK_THAT(failure("scene:play(function(wait) wait(1) end)\nlocal s = scene:snapshot()\nscene:restore(s)"),
             StartsWith("scene.lua:3: restore: the scene's script waits (scene.lua:1), which cannot be wound back"));
  CHECK_THAT(failure("scene:restore(3)"),
             StartsWith("scene.lua:1: restore: argument 1 must be a snapshot, got a number"));
  CHECK_THAT(failure("scene:probe('p', function() scene:snapshot() return 1 end)"),
             Contains("snapshot: it cannot be called while the world steps"));
}

TEST_CASE("snapshot: a hand holds what it held") {
  const auto scene = open(R"(
    local bar = scene:body{ mass = 1, inertia = vec(1, 1, 1), points = { tip = vec(1, 0, 0) } }
    scene:hand{ path = function(t) return vec(t, 1, 0) end }:grab(bar.tip))");
  steps(*scene, 10);
  const auto snapshot = scene->take_snapshot();
  steps(*scene, 30);
  const std::uint64_t held = state_hash(scene->world());
  release(scene->world(), 0);
  steps(*scene, 10);
  scene->restore(*snapshot);
  CHECK(scene->world().constraints.alive(scene->world().hands[0].grab));
  steps(*scene, 30);
  CHECK(state_hash(scene->world()) == held);
}

TEST_CASE(
    "snapshot: fifty of a scene whose probes have recorded for long share the record, and each puts its own back") {
  const auto scene = open(R"(
    local p = scene:particle { velocity = vec(1, 0, 0) }
    for i = 1, 4 do scene:probe("probe " .. i, function() return i * p.position.x end) end)");
  World& world = scene->world();
  const auto recorded = [&](std::size_t count) {
    for (Probe& probe : world.probes)
      for (std::size_t i = probe.values.size(); i < count; i++) probe.values.push_back(static_cast<double>(i));
  };
  steps(*scene, 1);
  recorded(200000);  // 14 min of steps, 6.4 MB
  std::vector<std::shared_ptr<const SceneSnapshot>> snapshots;
  const std::int64_t before = live_bytes();
  for (int i = 0; i < 50; i++) {
    snapshots.push_back(scene->take_snapshot());
    steps(*scene, 1);
  }
  CHECK(live_bytes() - before < 6400000);  // not 50 times as much
  for (const std::size_t i : {49u, 10u, 30u, 0u, 40u}) {
    scene->restore(*snapshots[i]);
    for (const Probe& probe : world.probes) {
      REQUIRE(probe.values.size() == 200000 + i);
      CHECK(probe.values[199999] == 199999.0);
    }
    if (i > 0) CHECK(world.probes[1].values.back() == Approx(2.0 * world.time));
  }
}
