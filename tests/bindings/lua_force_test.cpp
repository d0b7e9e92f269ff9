#include "bindings/lua_law_support.hpp"
#include "lua/scene/script_scene.hpp"

using namespace pantin;
using namespace pantin::lua_tests;
using Catch::Contains;

TEST_CASE("laws are values that say what they are and do not change") {
  CHECK(failure("assert(tostring(force.pair { potential = function(r) return r end }) == 'force.pair law')") == "");
  CHECK(failure("assert(tostring(force.point { force = function(p) return p.velocity end }) == 'force.point law')") ==
        "");
  CHECK_THAT(failure("local l = force.pair { potential = function(r) return r end } l.cutoff = 3"),
             Contains("scene.lua:1: a law cannot be changed"));
  CHECK_THAT(failure("local x = force.pair { potential = function(r) return r end }.cutoff"),
             Contains("a law has no fields"));
}

TEST_CASE("options of laws are checked, at the line of the scene") {
  const auto message = [](const std::string& options) { return failure("\nforce.pair { " + options + " }"); };
  const std::string law = "potential = function(r) return r end, ";
  CHECK(message(law + "cutoff = -1") == "scene.lua:2: force.pair: cutoff must be > 0 m, got -1");
  CHECK(message(law + "cutof = 1") ==
        "scene.lua:2: force.pair: unknown field 'cutof'. Did you mean 'cutoff'? Known are potential, tension, force, "
        "cutoff, shift, one_sided, exclude, parameters, strict, exact, implicit, name");
  CHECK_THAT(message(law + "cutoff = 0/0"), Contains("scene.lua:2: force.pair: cutoff must be a number [m], got NaN"));
  CHECK_THAT(message(law + "cutoff = 'far'"), Contains("cutoff must be a number [m], got a string"));
  CHECK_THAT(message(""), Contains("force.pair: needs one of potential, tension, force, a function"));
  CHECK_THAT(message("potential = 3"), Contains("potential must be a function of the scene, got a number"));
  CHECK_THAT(message("potential = math.sin"), Contains("potential must be a function of the scene, got a function"));
  CHECK_THAT(message(law + "tension = print"), Contains("force.pair: give one of potential, tension, not two"));
  CHECK_THAT(message(law + "shift = false"), Contains("shift is for a law with a cutoff"));
  CHECK_THAT(message("tension = function() end, cutoff = 1, shift = true"), Contains("shift is for a potential"));
  CHECK_THAT(message(law + "exclude = 1.5"), Contains("exclude must be a whole number from 0 to 8, got 1.5"));
  CHECK_THAT(message(law + "strict = 1"), Contains("strict must be true or false, got a number"));
  CHECK_THAT(message(law + "parameters = { k = 'x' }"), Contains("parameter 'k' must be a number, got a string"));
  CHECK_THAT(message(law + "parameters = { 3 }"), Contains("parameters must have names"));
  CHECK_THAT(message("force = function(d) return d end, implicit = true"),
             Contains("implicit is for a potential or a tension"));
  CHECK_THAT(message("tension = function(r) return r end, implicit = 'fully'"),
             Contains("implicit must be true, false or \"dissipative\", got \"fully\""));
  CHECK_THAT(failure("force.many { potential = function(p) return 0 end }"),
             Contains("force.many: count must be 2, 3 or 4, got nil"));
  CHECK_THAT(failure("force.many { count = 5, potential = function(p) return 0 end }"), Contains("got 5"));
  CHECK_THAT(failure("force.point { tension = function(p) return 0 end }"),
             Contains("force.point: unknown field 'tension'"));
}

TEST_CASE("what a law is like is kept with it") {
  const auto law =
      resolve("law = force.pair { cutoff = 2.5, one_sided = true, exclude = 2, tension = function(r) return r end }");
  CHECK(law.law().kind == LawKind::central);
  CHECK(law.law().cutoff == 2.5);
  CHECK(law.law().one_sided);
  CHECK(law.law().exclude == 2);
  CHECK(law.law().name == "scene.lua:1");
  CHECK(resolve("law = force.pair { name = 'glue', tension = function(r) return r end }").law().name == "glue");
  CHECK(resolve("law = force.pair { implicit = true, tension = function(r) return r end }").resolved.solve ==
        Solve::at_middle);
}

TEST_CASE("a law is traced once for the same names") {
  const auto law = resolve("runs = 0 law = force.pair { tension = function(r) runs = runs + 1 return r end }");
  lua::Script& script = lua::script_of(*law.scene);
  script.runtime.run([&](lua_State* state) {
    lua_getglobal(state, "runs");
    const lua_Integer before = lua_tointeger(state, -1);
    CHECK(before > 0);
    lua_getglobal(state, "law");
    const std::vector<lua::KnownNames> known(2, {"family 'ion'", {"charge"}}), others(2, {"family 'salt'", {}});
    const auto again = lua::resolve_law(state, -1, script.world, known, false);
    CHECK(again.laws == law.resolved.laws);
    lua_getglobal(state, "runs");
    CHECK(lua_tointeger(state, -1) == before);
    lua_pop(state, 1);
    CHECK(lua::resolve_law(state, -1, script.world, others, false).laws != law.resolved.laws);
  });
}

TEST_CASE("connections of particles of no family share a law") {
  const auto scene = open(R"(local law = force.pair { potential = function(r, a) return a.mass * r^2 end }
local p, q = scene:particle { at = vec(0, 0, 0) }, scene:particle { at = vec(1, 0, 0) }
scene:connect(p, q, law)
scene:connect(q, scene:particle { at = vec(2, 0, 0) }, law))");
  const World& world = scene->world();
  const std::vector<ConnectionId> ids = world.connections.ids();
  REQUIRE(ids.size() == 2);
  CHECK(world.connections[ids[0]].law == world.connections[ids[1]].law);
}

TEST_CASE("laws of the library are made by name, with their parameters checked") {
  const auto spring = resolve("law = force.spring { stiffness = 100, length = 2, damping = 3 }");
  REQUIRE(spring.resolved.laws.size() == 2);
  REQUIRE(spring.law().parameters.size() == 3);
  for (std::size_t i = 0; i < 3; i++)
    CHECK(spring.resolved.values[i] ==
          std::map<std::string, double>{{"stiffness", 100}, {"length", 2}, {"damping", 3}}.at(
              spring.law().parameters[i].name));
  const auto resting = resolve("law = force.spring { stiffness = 100 }");
  const auto length = std::find_if(resting.law().parameters.begin(), resting.law().parameters.end(),
                                   [](const Parameter& p) { return p.name == "length"; });
  CHECK(length->present);
  CHECK(failure("assert(tostring(force.lennard_jones { epsilon = 1, sigma = 1 }) == 'force.lennard_jones law')") == "");

  CHECK(failure("\nforce.spring { stiffness = -1 }") ==
        "scene.lua:2: force.spring: stiffness must be >= 0 N/m, got -1");
  CHECK_THAT(failure("force.spring {}"), Contains("scene.lua:1: force.spring: stiffness [N/m] is missing"));
  CHECK_THAT(failure("force.spring()"), Contains("scene.lua:1: force.spring: stiffness [N/m] is missing"));
  CHECK_THAT(failure("force.spring { stifness = 1 }"),
             Contains("force.spring: unknown field 'stifness'. Did you mean 'stiffness'?"));
  CHECK_THAT(failure("force.spring { stiffness = '1' }"),
             Contains("force.spring: stiffness must be a number [N/m], got a string"));
  CHECK_THAT(failure("force.wind { velocity = 3, linear = 1 }"),
             Contains("force.wind: velocity must be a vec [m/s], got a number"));
  CHECK_THAT(failure("force.lennard_jones { epsilon = 1, sigma = 1, cutoff = math.huge }"),
             Contains("cutoff must be > 0 m, got infinity"));
  CHECK_THAT(failure("local x = force.springs"), Contains("force: unknown law 'springs'. Did you mean 'spring'?"));
}

TEST_CASE("laws that differ in numbers alone are one") {
  const auto same = [](const std::string& first, const std::string& second) {
    const auto scene = resolve("law = " + first + " other = " + second);
    bool equal = false;
    lua::script_of(*scene.scene).runtime.run([&](lua_State* state) {
      lua_getglobal(state, "other");
      equal = lua::to_law(state, -1)->library->laws == scene.resolved.laws;
    });
    return equal;
  };
  CHECK(same("force.spring { stiffness = 1, length = 2 }", "force.spring { stiffness = 2, length = 3 }"));
  CHECK(
      same("force.wind { velocity = vec(1, 0, 0), linear = 1 }", "force.wind { velocity = vec(0, 2, 0), linear = 3 }"));
  CHECK(same("force.lennard_jones { epsilon = 1, sigma = 1 }", "force.lennard_jones { epsilon = 1, sigma = 1 }"));
  CHECK_FALSE(same("force.lennard_jones { epsilon = 1, sigma = 1 }", "force.lennard_jones { epsilon = 1, sigma = 2 }"));
  CHECK(same("force.lennard_jones { epsilon = 1, sigma = 1, cutoff = 3 }",
             "force.lennard_jones { epsilon = 1, sigma = 2, cutoff = 3 }"));
  CHECK_FALSE(same("force.spring { stiffness = 1 }", "force.spring { stiffness = 1, length = 2 }"));
  CHECK_FALSE(same("force.spring { stiffness = 1 }", "force.spring { stiffness = 1, cutoff = 2 }"));
  CHECK_FALSE(same("force.spring { stiffness = 1 }", "force.spring { stiffness = 1, one_sided = true }"));
  CHECK_FALSE(same("force.table { distances = { 1, 2, 3 }, potentials = { 1, 0, 0 } }",
                   "force.table { distances = { 1, 2, 3 }, potentials = { 2, 0, 0 } }"));
  const auto wind = resolve("law = force.wind { velocity = vec(1, 5, 7), linear = 3 }");
  for (std::size_t i = 0; i < wind.resolved.values.size(); i++)
    if (wind.law().parameters[i].name == "velocity_y") CHECK(wind.resolved.values[i] == 5);
  CHECK_THAT(failure("force.spring { stiffness = 1 } force.spring { stiffness = -1 }"),
             Contains("must be >= 0 N/m, got -1"));
}

TEST_CASE("a law of the library says which attribute it lacks") {
  const std::string source = "law = force.coulomb { constant = 1 }";
  const auto scene = resolve(source);
  lua::Script& script = lua::script_of(*scene.scene);
  script.runtime.run([&](lua_State* state) {
    lua_getglobal(state, "law");
    const std::vector<lua::KnownNames> known(2, {"family 'salt'", {}});
    CHECK_THROWS_WITH(lua::resolve_law(state, -1, script.world, known, true),
                      "force.coulomb: reads the attribute 'charge', which family 'salt' has not; give it attributes = "
                      "{ charge = … }");
  });
}
