// States of scenes that somebody changed on purpose, with a checksum that is right again: each is refused, or goes on.
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "bindings/lua_support.hpp"
#include "lua/scene/open.hpp"
#include "measure/measure.hpp"
#include "scene/errors.hpp"
#include "scene/interrupt.hpp"
#include "support/sealed_state.hpp"

using namespace pantin;
using namespace pantin::lua_tests;
using Catch::Contains;

namespace {

template <class T>
void put(std::string& state, std::size_t at, T value) {
  std::memcpy(state.data() + at, &value, sizeof value);
}

/// An index, a count, a number or a flag becomes what it must not be.
void change(std::string& state, std::size_t at, std::mt19937_64& random) {
  std::uint32_t word = 0;
  std::memcpy(&word, state.data() + at, sizeof word);
  switch (random() % 10) {
    case 0: return put(state, at, static_cast<std::uint8_t>(random()));
    case 1: return put(state, at, static_cast<std::uint8_t>(state[at] ^ (1 << random() % 8)));
    case 2: return put(state, at, ~std::uint32_t{0});
    case 3: return put(state, at, static_cast<std::uint32_t>(random() % 1000));
    case 4: return put(state, at, random() % 2 != 0 ? word + 1 : word - 1);
    case 5: return put(state, at, std::uint64_t{1} << 60);
    case 6: return put(state, at, std::nan(""));
    case 7: return put(state, at, std::numeric_limits<double>::infinity());
    case 8: return put(state, at, -1.0);
    default: return put(state, at, random());
  }
}

/// How many of `count` forged states are refused when they are opened. What is opened takes some steps, and is saved again.
int refused(const std::string& source, int steps, unsigned count) {
  SceneOptions roomy = options();
  roomy.memory_limit = std::size_t{1} << 30;
  const auto scene = lua::open_scene_text(source, "scene.lua", ".", roomy);
  for (int i = 0; i < steps; i++) scene->step();
  const std::string state = scene->state();
  const std::size_t script = state.find(source);
  int refused = 0;
  for (unsigned seed = 0; seed < count; seed++) {
    CAPTURE(seed);
    std::mt19937_64 random(seed);
    std::string forged = state;
    for (unsigned k = 0; k < 1 + seed % 3; k++) {
      std::size_t at = 0;
      do at = sizeof(StateHead) + random() % (state.size() - sizeof(StateHead) - 8);
      while (at + 8 > script && at < script + source.size());
      change(forged, at, random);
    }
    try {
      const auto opened = lua::open_state(sealed(forged), "forged.pantin", roomy);
      for (int i = 0; i < 8 && opened->world().failure.empty(); i++) opened->step();
      if (opened->world().failure.empty()) opened->state();
    } catch (const UsageError& error) { refused++; } catch (const Error& error) {
    }
  }
  return refused;
}

constexpr const char* chain = R"(
  local previous
  for i = 1, 6 do
    local link = scene:body { mass = 1, inertia = vec(0.01, 0.08, 0.08), at = vec(i, 4, 0),
                              points = { a = vec(-0.5, 0, 0), b = vec(0.5, 0, 0) } }
    if previous then scene:hinge(previous.b, link.a) else scene:nail(link.a) end
    previous = link
  end
  scene:probe("y", function() return previous.b.position.y end)
  scene:at(0.5, previous, function(link) link:remove() end)
)";

constexpr const char* heap = R"(
  scene:floor { height = 0 }
  for i = 1, 6 do scene:box { size = vec(1, 0.5, 1), at = vec(0.05 * i, 0.3 + 0.55 * i, 0), density = 100 } end
  for i = 1, 3 do scene:ball { radius = 0.3, at = vec(2, 0.5 + i, 0.1 * i), density = 100 } end
  scene:capsule { radius = 0.2, from = vec(-1, 2, 0), to = vec(-2, 2.5, 0), density = 100 }
  scene:on("touched", function(contact) scene:result("n", 1) end)
)";

constexpr const char* gas = R"(
  local f = scene:family("gas", { radius = 0.1, attributes = { charge = 1 } })
  local g = scene:family("dust", { radius = 0.1 })
  local ps = {}
  for i = 1, 40 do ps[i] = scene:particle { at = vec(i % 4, i // 4 % 4, i // 16), family = i % 3 == 0 and g or f } end
  scene:interact(f, f, force.pair { cutoff = 1.8, potential = function(r, a, b) return a.charge * b.charge / r end })
  scene:interact(f, g, force.lennard_jones { epsilon = 0.1, sigma = 0.8, cutoff = 2 })
  scene:connect(ps[1], ps[2], force.spring { stiffness = 10 })
  scene:connect(ps[3], ps[4], force.pair { tension = function(r) if r == 7 then return 0 end return 3 * (r - 1) end })
  scene:field(scene, force.drag { linear = 0.1 })
  scene:emitter { at = vec(0, 5, 0), rate = 50, lifetime = 0.5, family = g }
)";

constexpr const char* edited = R"(
  scene:floor { height = -3 }
  local list, hinges = {}, {}
  for i = 1, 5 do
    list[i] = scene:body { mass = 1, inertia = vec(0.1, 0.1, 0.1), at = vec(i, 1, 0), shape = shape.ball { radius = 0.3 },
                           points = { a = vec(-0.5, 0, 0), b = vec(0.5, 0, 0) } }
  end
  for i = 1, 4 do hinges[i] = scene:hinge(list[i].b, list[i + 1].a) end
  scene:nail(list[1].a)
  scene:motor(list[1], list[2], { axis = vec(0, 0, 1), speed = 1, max_torque = 5 })
  scene:string({ list[1].a, list[3].a, list[5].b }, { length = 6 })
  scene:on_path(list[5].b, { vec(5.5, 1, 0), vec(7, 0, 1), vec(9, -1, 0) })
  scene:at(0.02, function() hinges[3]:cut() end)
  scene:at(0.04, function() scene:merge(list[4], list[5]) end)
  scene:at(0.05, function() scene:connect(list[1].a, list[3].b, force.spring { stiffness = 100 }) end)
  scene:every(0.1, function() list[2]:kick(vec(0, 1, 0)) end)
  scene:follow(list[3].a, function(t) return vec(3, 2 + t, 0) end, { max_force = 10 })
)";

}  // namespace

TEST_CASE("forged_states: each is refused, or goes on") {
  CHECK(refused(chain, 20, 150) > 20);
  CHECK(refused(heap, 60, 150) > 20);
  CHECK(refused(gas, 20, 150) > 20);
  CHECK(refused(edited, 20, 150) > 20);
}

TEST_CASE("forged_states: each of many is refused, or goes on", "[slow]") {
  CHECK(refused(chain, 20, 3000) > 400);
  CHECK(refused(heap, 60, 3000) > 400);
  CHECK(refused(gas, 20, 3000) > 400);
  CHECK(refused(edited, 20, 3000) > 400);
}

TEST_CASE(
    "forged_states: a way to a waiting script that does not fit its time is refused, and Ctrl-C ends a long one") {
  const auto scene = open("scene:particle {} scene:play(function(wait) wait(1) end)");
  for (int i = 0; i < 12; i++) scene->step();
  const std::string state = scene->state();
  const auto reopen = [&](std::uint64_t steps, double time) {
    std::string forged = state;
    put(forged, state.size() - 24, steps);
    put(forged, state.size() - 16, time);
    return lua::open_state(sealed(forged), "forged.pantin", options());
  };
  const double time = scene->world().time;
  CHECK(state_hash(reopen(12, time)->world()) == state_hash(scene->world()));
  constexpr std::uint64_t endless = std::uint64_t{1} << 60;
  CHECK_THROWS_WITH(reopen(endless, time), Contains("forged.pantin: the state cannot be read: it is to be of"));
  CHECK_THROWS_WITH(reopen(endless, std::nan("")), Contains("it is to be of"));
  CHECK_THROWS_WITH(reopen(11, time), Contains("it did not come to the same state again"));
  interrupt_scripts();
  CHECK_THROWS_AS(reopen(endless, 1e18), Interrupted);
  allow_scripts();
}
