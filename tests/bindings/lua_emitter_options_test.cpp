// Emitters, looks and functions of age, as a scene gives them.
#include <catch2/catch.hpp>

#include "bindings/lua_support.hpp"
#include "step/step.hpp"

using namespace pantin;
using namespace pantin::lua_tests;
using Catch::Contains;

TEST_CASE("lua: an emitter makes particles of its family at its rate", "[lua]") {
  const auto scene = open(R"(
    drops = scene:family("drops", { attributes = { heat = 2 }, mass = 0.1 })
    e = scene:emitter { at = vec(0, 1, 0), rate = 100, velocity = vec(1, 0, 0), lifetime = 0.5, family = drops, heat = 5,
                        look = "glow", name = "tap" }
    scene:at(1, function()
      scene:result("x", e.count * 1000 + e.made)
      local p = drops.particles[1]
      assert(p.heat == 5 and p.mass == 0.1 and p.look == "glow" and p.family == drops and e.family == drops)
      assert(scene:find "tap" == e and e.alive and e.max == math.huge and e.rate == 100 and e.lifetime == 0.5)
      e.rate = 0
    end)
    scene:at(2, function()
      assert(e.count == 0 and e.made < 105)
      e:remove()
      assert(not e.alive)
    end)
  )");
  while (scene->world().time < 2.1) scene->step();
  CHECK(std::get<double>(scene->results().at("x")) == 51100);  // that of 0.5 s goes in this step
}

TEST_CASE("lua: an emitter's place is a vec, a box or a point, its rate a number or a function", "[lua]") {
  CHECK(number(R"(
    local p = scene:particle { at = vec(1, 2, 3) }
    local e = scene:emitter { at = p, rate = function(t) return 10 * t end, spread = 0.5, max = 7, enabled = false }
    assert(e.at == p.points[1])
    e.at = vec(1, 1, 1)
    assert(e.at == vec(1, 1, 1))
    e.at = { vec(1, 0, 0), vec(0, 1, 0) }
    assert(e.at[1] == vec(0, 0, 0) and e.at[2] == vec(1, 1, 0))
    e.lifetime = { min = 1, max = 2 }
    assert(e.lifetime.min == 1 and e.lifetime.max == 2)
    e.velocity = vec(0, 1, 0) e.spread = 1 e.max = 9 e.enabled = true
    assert(e.velocity == vec(0, 1, 0) and e.spread == 1 and e.enabled)
    scene:result("x", e.max)
  )") == 9);
}

TEST_CASE("lua: what is wrong with an emitter is said with its unit", "[lua]") {
  const auto fails = [](const std::string& options, const char* message) {
    CHECK_THAT(failure("scene:emitter { " + options + " }"), Contains("scene.lua:1") && Contains(message));
  };
  fails("at = vec(0, 0, 0)", "emitter: rate must be given, a number [1/s] or a function of time");
  fails("rate = -1", "rate must be >= 0 1/s");
  fails("rate = 1, spread = 9", "spread must be from 0 to pi rad, got 9");
  fails("rate = 1, at = 3", "at must be a vec [m], a box { vec, vec }, a point or a particle, got a number");
  fails("rate = 1, at = { vec(0, 0, 0) }", "two opposite corners [m]");
  fails("rate = 1, lifetime = { min = 2, max = 1 }", "the longest lifetime must not be below the shortest");
  fails("rate = 1, look = 'flame'", "look must be \"ball\", \"glow\" or \"streak\", got \"flame\"");
  fails("rate = 1, max = 1.5", "max must be a whole number > 0, got 1.5");
  fails("rate = 1, colour = '#fff'", "Did you mean 'color'?");
  fails("rate = function() return -1 end", "rate must be >= 0 1/s, got -1");
}

TEST_CASE("lua: color, radius and attributes may be functions of age and life", "[lua]") {
  const auto scene = open(R"(
    local f = scene:family("f", { attributes = { heat = function(age, life) return 10 * (1 - age / life) end },
                                  radius = function(age) return 0.1 + age end })
    p = scene:particle { family = f, lifetime = 4,
      color = function(age, life) if age < life / 2 then return "#ff0000" end return { 0, age / life, 1 } end }
    q = scene:particle { family = f, radius = 2, heat = 3 }
    scene:at(1.01, function() assert(p.color == "#ff0000") end)
    scene:at(3, function()
      p.heat = 7
      assert(p.heat == 7 and q.heat == 3 and q.radius == 2)
      q.radius = function(age) return age end
      p.color = "#00ff00"
      assert(p.color == "#00ff00")
      scene:result("x", math.abs(q.radius - 3) < 0.01 and math.abs(p.radius - 3.1) < 0.01)
    end)
  )");
  while (scene->world().time < 3.1) scene->step();
  CHECK(std::get<bool>(scene->results().at("x")));
}

TEST_CASE("lua: a function of age that cannot be one says why, with its line", "[lua]") {
  CHECK_THAT(failure("scene:particle { radius = function(age) return 'big' end }"),
             Contains("scene.lua:1") && Contains("it returns a string"));
  CHECK_THAT(failure("scene:particle { color = function(age) return 3 end }"), Contains("it returns a number"));
  CHECK_THAT(failure("scene:particle { radius = function(age) return age.x end }"), Contains("scene.lua:1"));
}
