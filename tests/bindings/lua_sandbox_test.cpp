#include "bindings/lua_support.hpp"

#include <cmath>

#include "base/functions.hpp"
#include "support/sources.hpp"

using namespace pantin;
using namespace pantin::lua_tests;
using Catch::Contains;
using Catch::StartsWith;

TEST_CASE("a scene reaches no files, no other code and no finalizers") {
  for (const char* name :
       {"io", "os", "debug", "package", "load", "dofile", "loadfile", "collectgarbage", "string.dump"})
    CHECK(word("scene:result('x', type(" + std::string(name) + "))") == "nil");
  CHECK(failure("setmetatable({}, { __gc = function() end })") ==
        "scene.lua:1: setmetatable: __gc is not allowed in scenes");
  CHECK(word("scene:result('x', tostring(getmetatable(scene)))") == "scene");
  CHECK_THAT(failure("\x1bLua"), Contains("scene.lua"));
}

TEST_CASE("sandbox: no table is weak, since what it has lost depends on the memory of the run") {
  CHECK_THAT(failure("setmetatable({}, { ['__mo' .. 'de'] = 'v' })"),
             Contains("scene.lua:1: setmetatable: __mode is not"));
  CHECK_THAT(failure("local mt = {}\nlocal t = setmetatable({}, mt)\nmt.__mode = 'k'"),
             Contains("scene.lua:3: __mode is not"));
  CHECK(word(R"(
    local mt = {}
    local t = setmetatable({}, mt)
    mt["__mo" .. "de"] = "v"
    for i = 1, 100 do t[i] = { i } end
    for i = 1, 1e5 do local lost = { i } end
    for i = 1, 100 do assert(t[i][1] == i) end
    scene:result("x", mt["__mo" .. "de"]))") == "v");
}

TEST_CASE("an error names what comes first in an order that is the same in every run") {
  CHECK_THAT(failure("scene:family('q', { attributes = { d = 'x', a = 'y', c = 'z', b = 'w' } })"),
             Contains("attribute 'a' must"));
  const std::string in_store = "scene:snapshot()", only = " is a function, and only plain values";
  CHECK_THAT(failure("scene.store.x = { d = print, b = { a = print }, c = print } " + in_store),
             Contains("scene.store.x.c" + only));
  CHECK_THAT(failure("local t = { f = print } scene.store.c = t scene.store.b = t scene.store.d = t " + in_store),
             Contains("scene.store.b.f" + only));
  const std::string several = failure("pairs { [print] = 1, [{}] = 2, [coroutine.create(print)] = 3 }");
  CHECK(several == failure("pairs { [{}] = 2 }"));
  CHECK(failure("error { [{}] = 2, [setmetatable({}, {})] = 1 }") ==
        "scene.lua:1: error: { [a table] = 1, [a table] = 2 }");
}

TEST_CASE("a coroutine that fails closes its variables, and hands its error on") {
  CHECK(word(R"(
    local closed = ""
    local function of(name)
      return setmetatable({}, { __close = function() closed = closed .. name end })
    end
    local f = coroutine.wrap(function(a, b)
      local x <close> = of "x"
      local c, d = coroutine.yield(a + b)
      error { c * d }
    end)
    assert(f(1, 2) == 3)
    local ok, e = pcall(f, 3, 4)
    assert(not ok and e[1] == 12 and closed == "x")
    assert(select(2, pcall(f)) == "cannot resume dead coroutine")
    assert(select("#", coroutine.wrap(function() return 1, nil, nil end)()) == 3)
    local co = coroutine.create(function() local y <close> = of "y" error "z" end)
    assert(not coroutine.resume(co) and closed == "x")
    assert(not coroutine.close(co))
    scene:result("x", closed))") == "xy");
}

TEST_CASE("pairs and next go in the same order in every run") {
  const std::string keys = R"(
    local b = scene:body { mass = 1, points = { vec(0, 0, 0) }, name = "late" }
    local t = { b = 1, a = 1, [true] = 1, [3] = 1, [2.5] = 1, [b] = 1, [-1] = 1, zz = 1, [false] = 1 }
  )";
  CHECK(word(keys + R"(local s = "" for k in pairs(t) do s = s .. tostring(k) .. " " end scene:result("x", s))") ==
        "-1 2.5 3 a b zz false true body 'late' ");
  CHECK(
      word(
          keys +
          R"(local s, k = "", next(t) while k ~= nil do s = s .. tostring(k) .. " " k = next(t, k) end scene:result("x", s))") ==
      "-1 2.5 3 a b zz false true body 'late' ");
  CHECK(number("local t = { a = 1, b = 2, c = 3 } local n = 0 for k in pairs(t) do n = n + 1 t.c = nil end "
               "scene:result('x', n)") == 2);
  CHECK(number("local t = setmetatable({}, { __pairs = function() return function(_, k) if not k then return 7 end end "
               "end }) "
               "for k in pairs(t) do scene:result('x', k) end") == 7);
  CHECK_THAT(failure("for k in pairs { [{}] = 1 } do end"), StartsWith("scene.lua:1: pairs: a key that is no number"));
}

TEST_CASE("table.sort is stable, also where Lua's own would look at the clock") {
  CHECK(word("local t = { 5, 2.5, 9, -1, 2 } table.sort(t) scene:result('x', table.concat(t, ' '))") == "-1 2 2.5 5 9");
  CHECK(word("local t = { 'b', 'a' } table.sort(t, function(a, b) return a > b end) scene:result('x', t[1] .. t[2])") ==
        "ba");
  CHECK(word(R"(
    local t = {}
    for i = 1, 1000 do t[i] = { key = i * 7919 % 3, place = i } end
    table.sort(t, function(a, b) return a.key < b.key end)
    for i = 2, #t do
      assert(t[i - 1].key < t[i].key or t[i - 1].key == t[i].key and t[i - 1].place < t[i].place)
    end
    table.sort({})
    table.sort({ 1 })
    scene:result("x", "stable"))") == "stable");
  CHECK_THAT(failure("table.sort { 1, 'a' }"), StartsWith("scene.lua:1: sort: cannot compare a string with a number"));
  CHECK_THAT(failure("table.sort({ 1, 2 }, 3)"), StartsWith("scene.lua:1: ") && Contains("function expected"));
}

TEST_CASE("random numbers come from scene.seed") {
  const std::string draw = " local s = '' for i = 1, 5 do s = s .. math.random(1000) .. ' ' end scene:result('x', s)";
  CHECK(word(draw) == word(draw));
  CHECK(word("scene.seed = 1" + draw) == word(draw));
  CHECK(word("scene.seed = 2" + draw) != word(draw));
  CHECK(word(R"(
    local low, high, sum = 9, 0, 0
    for i = 1, 10000 do
      local n, u = math.random(3, 8), math.random()
      assert(math.type(n) == "integer" and u >= 0 and u < 1)
      low, high, sum = math.min(low, n), math.max(high, n), sum + u
    end
    assert(math.abs(sum / 10000 - 0.5) < 0.02)
    assert(math.random(1, 1) == 1 and math.type(math.random(0)) == "integer")
    assert(math.random(math.mininteger, math.maxinteger) ~= math.random(math.mininteger, math.maxinteger))
    scene:result("x", low .. " " .. high))") == "3 8");
  CHECK_THAT(failure("math.randomseed(3)"), Contains("scene.seed"));
  CHECK_THAT(failure("math.random(2, 1)"), Contains("interval is empty"));
}

TEST_CASE("elementary functions and ^ have the engine's bits") {
  CHECK(number("scene:result('x', math.sin(1.1) + math.exp(0.3) * math.atan(1, 3))") ==
        functions::sin(1.1) + functions::exp(0.3) * functions::atan2(1, 3));
  CHECK(number("local b, e = 1.7, 3.3 scene:result('x', b ^ e)") == functions::pow(1.7, 3.3));
  CHECK(number("scene:result('x', 1.7 ^ 3.3)") == functions::pow(1.7, 3.3));
  CHECK(number("scene:result('x', math.log(8, 2))") == 3.0);
  CHECK(number("scene:result('x', math.tanh(0.4) + math.sinh(1.2) * math.cosh(0.3))") ==
        functions::tanh(0.4) + functions::sinh(1.2) * functions::cosh(0.3));
  for (const char* name : {"pow", "log10"})
    CHECK(word("scene:result('x', type(math." + std::string(name) + "))") == "nil");
  CHECK(std::pow(2.0, 10.0) == 1024.0);
}

TEST_CASE("require looks in the scene's folder, then in the libraries, and nowhere else") {
  const std::string home = sources::folder();
  CHECK(failure("require 'nowhere'") == "scene.lua:1: require: there is no 'nowhere'; looked for ./nowhere.lua, " +
                                            home + "/scripts/lib/nowhere.lua, " + home +
                                            "/scripts/behaviours/nowhere.lua");
  for (const char* name : {"../secret", "/etc/passwd", "", "..secret", "a/../../b"})
    CHECK_THAT(failure("require '" + std::string(name) + "'"), Contains("must be a name like"));
}

TEST_CASE("xpcall calls its handler and gives what it returns") {
  CHECK(word("scene:result('x', select(2, xpcall(error, function(m) return m .. '!' end, 'no', 0)))") == "no!");
  CHECK(number("scene:result('x', select(2, xpcall(math.max, print, 3, 4)))") == 4);
}

TEST_CASE("no text has an address in it: what is shown is numbered in the order of showing") {
  CHECK(word(R"(
    local t, f = {}, function() end
    scene:result("x", tostring(t) .. " " .. tostring(f) .. " " .. tostring(t) .. " " .. tostring(print) .. " " ..
      tostring(coroutine.create(f)) .. " " .. tostring({}) .. " " .. tostring(nil) .. " " .. tostring(1.5)))") ==
        "table: 1 function: 2 table: 1 function: 3 thread: 4 table: 5 nil 1.5");
  CHECK(word("local t = {} scene:result('x', string.format('%5.1f %% %s %d %q %s', 1, t, 2, 'a', vec(1, 2, 3)))") ==
        "  1.0 % table: 1 2 \"a\" vec(1, 2, 3)");
  CHECK(word("scene:result('x', tostring(setmetatable({}, { __name = 'leaf' })) .. tostring(setmetatable({}, "
             "{ __tostring = function() return '!' end })))") == "leaf: 1!");
  CHECK(failure("string.format('%d %p', 1, {})") ==
        "scene.lua:1: format: %p would give an address, which differs from run to run; use %s");
  CHECK_THAT(failure("string.format('%d', 'x')"),
             StartsWith("scene.lua:1: bad argument #2 to 'format' (number expected, got string)"));
  CHECK_THAT(failure("string.format('%d %s', 1)"), Contains("bad argument #3 to 'format' (no value)"));
  CHECK_THAT(failure("local x = scene[{}]"), StartsWith("scene.lua:1: scene: unknown field 'table: 1'"));
  CHECK_THAT(failure("setmetatable(scene, {})"),
             StartsWith("scene.lua:1: bad argument #1 to 'setmetatable' (table expected, got scene)"));
}
