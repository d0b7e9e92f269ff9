#include "bindings/lua_law_support.hpp"
#include "lua/scene/script_scene.hpp"

using namespace pantin;
using namespace pantin::lua_tests;
using Catch::Contains;

namespace {

std::vector<std::string> warnings(const LawScene& law) { return law.scene->warnings(); }

/// The message of a call that must fail.
std::string run_failure(const Law& law, const Seen& seen) {
  try {
    outputs_of(law, seen);
  } catch (const Error& error) { return error.what(); }
  return "";
}

}  // namespace

TEST_CASE("a law that cannot be traced is called, with one warning of why and what it costs") {
  const auto law = resolve(
      "law = force.pair { potential = function(r, a, b)\n if a.charge == 1 then return r^2 end\n return r^3 end }");
  REQUIRE(law.law().called);
  REQUIRE(warnings(law).size() == 1);
  CHECK_THAT(
      warnings(law)[0],
      Contains("scene.lua:1: this law is called in Lua for every pair, some 300 times slower than traced (a force or "
               "tension: 50) and on one core; it cannot be traced: scene.lua:2: == or ~= on numbers"));
  // The test sees plain numbers; the force is the derivative, exact to round-off.
  for (double r : {0.3, 1.0, 2.7}) {
    auto got = outputs_of(law.law(), pair(r, 1));
    CHECK(got[0] == Approx(2.0).epsilon(1e-15));
    CHECK(got[1] == Approx(r * r).epsilon(1e-15));
    got = outputs_of(law.law(), pair(r, 2));
    CHECK(got[0] == Approx(3 * r).epsilon(1e-15));
    CHECK(got[1] == Approx(r * r * r).epsilon(1e-15));
  }
}

TEST_CASE("a loop as long as the distance, and a table that is looked up, work when called") {
  const auto loop = resolve(
      "law = force.pair { potential = function(r) local n = 0 while r > 1 do r, n = r - 1, n + 1 end return n + r^2 "
      "end }");
  REQUIRE(loop.law().called);
  auto got = outputs_of(loop.law(), pair(3.25));
  CHECK(got[0] * 3.25 == 0.5);
  CHECK(got[1] == 3.0625);
  const auto table = resolve(
      "local t = { 1, 4, 9, 16 } law = force.pair { cutoff = 4, shift = false, potential = function(r)"
      "local i = math.floor(math.min(r, 2.9)) local x = r - i return t[i + 1] * (1 - x) + t[i + 2] * x end }");
  REQUIRE(table.law().called);
  got = outputs_of(table.law(), pair(1.5));
  CHECK(got[0] * 1.5 == 5.0);
  CHECK(got[1] == 6.5);
}

TEST_CASE("called and traced agree through where, if and either kind of function") {
  const std::string where = "potential = function(r) return where(r < 1.2, 20 * (r - 1)^2, 0.8 + 8 * (r - 1.2)) end }";
  const std::string branch =
      "potential = function(r) if r < 1.2 then return 20 * (r - 1)^2 end return 0.8 + 8 * (r - 1.2) end }";
  const std::string tension = "tension = function(r) if r < 1.2 then return 40 * (r - 1) end return 8 end }";
  const auto a = resolve("law = force.pair { " + where), b = resolve("law = force.pair { " + branch),
             c = resolve("law = force.pair { " + tension);
  for (double r : {0.2, 0.999, 1.0, 1.1, 1.3, 40.0}) {
    const double wanted = (r < 1.2 ? 40 * (r - 1) : 8) / r;
    for (const Law* law : {&a.law(), &a.called(), &b.law(), &b.called(), &c.law(), &c.called()})
      CHECK(std::fabs(outputs_of(*law, pair(r))[0] - wanted) <= 1e-12 * 40);
  }
}

TEST_CASE("what a law returns is looked at") {
  const auto law = resolve(
      "law = force.pair { tension = function(r, rate, a) if r == 7.5 then return 'x' elseif r == 8.5 then return end "
      "return a.charge * math.sqrt(r - 0.1) + (r == 9.5 and nil or 0) end }");
  REQUIRE(law.law().called);
  CHECK(run_failure(law.law(), pair(1.1, 2)) == "");
  CHECK(run_failure(law.law(), pair(0.01, 2)) ==
        "scene.lua:1: the law gives a force or an energy of NaN, at distance 0.01 m");
  CHECK(run_failure(law.law(), pair(7.5, 2)) ==
        "scene.lua:1: the law must return a number [N], got a string, at distance 7.5 m");
  CHECK(run_failure(law.law(), pair(8.5, 2)) ==
        "scene.lua:1: the law must return a number [N], got nil, at distance 8.5 m");
  const auto error = resolve(
      "law = force.pair { tension = function(r, rate, a)\n if a.charge == 7 then error('no such ion') end return r end "
      "}");
  CHECK(run_failure(error.law(), pair(2, 7)) == "scene.lua:2: no such ion, at distance 2 m");
}

TEST_CASE("a called law obeys the limit of time") {
  const auto law =
      resolve("law = force.pair { tension = function(r, rate, a) while a.charge == 7 do end return r end }");
  CHECK_THAT(run_failure(law.law(), pair(2, 7)), Contains("scene.lua:1: the script did not come back within 0.2 s"));
}

TEST_CASE("strict and implicit refuse what cannot be traced") {
  CHECK_THAT(refusal("law = force.pair { strict = true, tension = function(r) return r == 1 and 1 or r end }"),
             Contains("force.pair: strict = true, and the law cannot be traced: scene.lua:1: == or ~="));
  CHECK_THAT(refusal("law = force.pair { implicit = true, tension = function(r) return r == 1 and 1 or r end }"),
             Contains("force.pair: implicit needs a law that can be traced"));
}

TEST_CASE("a law whose function changes its mind is found out on real pairs") {
  const auto law = resolve("mood = 1 law = force.pair { tension = function(r) return mood * r end }");
  REQUIRE_FALSE(law.law().called);
  const Seen seen = pair(1.5);
  std::vector<double> given;
  std::vector<const double*> inputs;
  for (const Input& i : law.resolved.function->inputs_wanted()) given.push_back(seen.contains(i) ? seen.at(i) : 0.0);
  for (double& x : given) inputs.push_back(&x);
  Called::Block block;
  block.n = 1;
  block.inputs = inputs;
  CHECK(lua::recheck_law(law.resolved, block) == "");
  lua::script_of(*law.scene).runtime.run([](lua_State* state) {
    lua_pushnumber(state, 2);
    lua_setglobal(state, "mood");
  });
  CHECK(lua::recheck_law(law.resolved, block) == "traced, the force is 1 and called it is 2 at r = 1.5");
}

TEST_CASE("a potential that makes a text of its argument has no force, and is told so; print may show it") {
  const std::string text = "a text has no derivative, and the derivative of a potential is its force";
  for (const char* made : {"tonumber(tostring(r))", "tonumber(r .. '')", "0 + ('%s'):format(r)"})
    CHECK_THAT(refusal(std::string("law = force.pair { potential = function(r)\nreturn ") + made + " end }"),
               Contains("scene.lua:2: ") && Contains(text));
}
