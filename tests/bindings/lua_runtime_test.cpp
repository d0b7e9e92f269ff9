#include <time.h>

#include <chrono>
#include <memory>
#include <thread>

#include "bindings/lua_support.hpp"
#include "lua/scene/open.hpp"
#include "lua/vm/watchdog.hpp"
#include "scene/errors.hpp"
#include "scene/interrupt.hpp"

using namespace pantin;
using namespace pantin::lua_tests;
using Catch::Contains;
using Catch::StartsWith;

TEST_CASE("a script that does not come back is stopped with its line") {
  const std::string stopped = "the script did not come back within 0.2 s and was stopped (--script-limit)";
  CHECK(failure("local x = 0\nwhile true do x = x + 1 end") == "scene.lua:2: " + stopped);
  SECTION("in a callback") {
    CHECK(failure("scene:on('step', function()\nwhile true do end end)") == "scene.lua:2: " + stopped);
    CHECK(failure("scene:at(0.01, function()\n\nwhile true do end end)") == "scene.lua:3: " + stopped);
  }
  SECTION("pcall and xpcall cannot swallow it") {
    CHECK(failure("while true do pcall(function() while true do end end) end") == "scene.lua:1: " + stopped);
    CHECK(failure("while true do xpcall(function() while true do end end, function() while true do end end) end") ==
          "scene.lua:1: " + stopped);
  }
  SECTION("nor can coroutines") {
    CHECK_THAT(failure("coroutine.wrap(function() while true do end end)()"), Contains(stopped));
    CHECK(failure(
              "local co = coroutine.create(function() while true do pcall(function() while true do end end) end end)\n"
              "while true do coroutine.resume(co) end") == "scene.lua:2: " + stopped);
    CHECK_THAT(
        failure("local co = coroutine.create(function() local x <close> = setmetatable({}, { __close = function() "
                "while true do end end }) coroutine.yield() end)\ncoroutine.resume(co) coroutine.close(co)\n"
                "while true do end"),
        Contains(stopped));
  }
  SECTION("nor can what a coroutine closes when it was stopped") {
    const std::string closing =
        "local function f() local x <close> = setmetatable({}, { __close = function() while true do end end }) "
        "while true do end end\n";
    CHECK_THAT(failure(closing + "coroutine.wrap(f)()"), Contains(stopped));
    CHECK_THAT(failure(closing + "pcall(coroutine.wrap(f))"), Contains(stopped));
    const auto scene =
        open(closing +
             "local co = coroutine.create(f) scene:on('step', function()\n"
             "if coroutine.status(co) == 'dead' then coroutine.close(co) else coroutine.resume(co) end end)");
    CHECK_THROWS_WITH(scene->step(), Contains(stopped));
    CHECK_THROWS_WITH(scene->step(), "scene.lua:3: close: the coroutine was stopped");
  }
  SECTION("nor can one long call of a library's function") {
    const char* const calls[] = {"s:find('.-.-.-b')",
                                 "s:match('.-.-.-b')",
                                 "s:gmatch('.-.-.-b')()",
                                 "s:gsub('.-.-.-b', '')",
                                 "pcall(string.find, s, '.-.-.-b')",
                                 "s:find(s:sub(1, 500000) .. 'b', 1, true)",
                                 "('('):rep(1e6):find('%b()')",
                                 "s:find('[' .. s .. 'b-z]*x')",
                                 "table.move({}, 1, 1e15, 2)",
                                 "table.insert(setmetatable({}, { __len = function() return 1e15 end }), 1, 0)",
                                 "table.remove(setmetatable({}, { __len = function() return 1e15 end }), 1)"};
    auto hasty = options();
    hasty.script_limit = 0.03;
    for (const char* call : calls)
      CHECK_THROWS_WITH(lua::open_scene_text(text("local s = ('a'):rep(1e6);\n", call), "scene.lua", "", hasty),
                        "scene.lua:2: the script did not come back within 0.03 s and was stopped (--script-limit)");
    CHECK(failure("assert(string.rep('', 1e15) == '')") == "");
    CHECK_THAT(failure("string.format('%99999d', 1)"), StartsWith("scene.lua:1: invalid conversion"));
    CHECK(failure("string.format(('%d'):rep(10001))") == "scene.lua:1: format: at most 10000 values at once");
  }
  SECTION("0 is no limit, and time in many short calls does not add up") {
    auto o = options();
    o.script_limit = 0;
    const auto scene = lua::open_scene_text("local x = 0 for i = 1, 3e7 do x = x + 1 end", "scene.lua", "", o);
    CHECK(failure("scene:on('step', function() for i = 1, 2e6 do end end)") == "");
  }
}

TEST_CASE("the limit counts a script's own processor time, not that of a busy machine") {
  using namespace std::chrono;
  const std::unique_ptr<lua_State, void (*)(lua_State*)> state(luaL_newstate(), lua_close);
  lua::Watch watch(std::size_t{1} << 30);
  lua::Watch* previous = watch.enter(state.get(), 0.05);
  std::this_thread::sleep_for(milliseconds(150));
  CHECK_FALSE(watch.over);
  const auto start = steady_clock::now();
  while (!watch.over && steady_clock::now() - start < seconds(20)) {}
  CHECK(watch.over);
  watch.leave(previous);
}

TEST_CASE("a script that joins what never ends is stopped before its memory is full") {
  auto roomy = options();
  roomy.memory_limit = std::size_t{1} << 30;
  roomy.script_limit = 0.2;
  const char* endless = "table.concat(setmetatable({}, { __len = function() return 1 << 50 end, __index = type }))";
  CHECK_THROWS_WITH(lua::open_scene_text(endless, "scene.lua", "", roomy), Contains("did not come back within 0.2 s"));
  CHECK(failure(R"(assert(table.concat({}) == "" and table.concat({ 1, 2.5, "x" }, ", ") == "1, 2.5, x" and
    table.concat({ 1, 2, 3 }, "-", 2) == "2-3" and table.concat({ 1, 2, 3 }, "-", 2, 2) == "2" and
    table.concat({ [math.maxinteger] = 7 }, "-", math.maxinteger, math.maxinteger) == "7"))") == "");
  CHECK(failure("table.concat({ 1, {} })") == "scene.lua:1: invalid value (at index 2) in table for 'concat'");
}

namespace {

/// [s] of this thread's processor that a scene takes until the limit of 0.1 s for its script stops it.
double seconds_until_stopped(const std::string& source) {
  auto hasty = options();
  hasty.memory_limit = std::size_t{1} << 30;
  hasty.script_limit = 0.1;
  const auto now = [] {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
  };
  const double start = now();
  CHECK_THROWS_WITH(lua::open_scene_text(source, "scene.lua", "", hasty), Contains("did not come back within 0.1 s"));
  return now() - start;
}

}  // namespace

TEST_CASE("a script that has a library do much at once is stopped in time") {
  const char* const calls[] = {
      "local s, t = ('x'):rep(60 << 20), {} for i = 1, 15 do t[i] = s end while true do pcall(table.concat, t) end",
      "local s = ('x'):rep(60 << 20) while true do pcall(string.gsub, ('a'):rep(15), 'a', s) end",
      "local s = ('x'):rep(60 << 20) while true do pcall(string.gsub, s, '^.*$', ('%0'):rep(15)) end",
      "local s = ('x'):rep(60 << 20) while true do pcall(string.find, s, ('('):rep(15) .. '.*' .. (')'):rep(15)) end",
      "local t = {} for i = 1, 1e5 do t[i + 0.5] = true end while true do for i = 1, 20 do pcall(pairs, t) end end",
      "table.sort(setmetatable({}, { __len = function() return 10000000 end, __index = type, __newindex = rawequal }))",
      "local t = {} for i = 1, 3e6 do t[i] = i end error(t)"};
  for (const char* call : calls) {
    INFO(call);
    CHECK(seconds_until_stopped(call) < 0.6);
  }
}

TEST_CASE("a script that has the engine do much at once is stopped in time") {
  const std::string corners =
      "local p = {} for i = 1, 1000 do local y = 1 - (2 * i - 1) / 1000 local r, a = math.sqrt(1 - y * y), 2.4 * i\n"
      "p[i] = vec(r * math.cos(a), y, r * math.sin(a)) end\n";
  const std::string calls[] = {
      corners + "scene:shatter(scene:body { shape = shape.hull(p) }, { pieces = 300 })",
      "local p = {} for i = 1, 9000 do local a = i / 4500 * math.pi p[i] = vec(math.cos(a), math.sin(a), 0) end\n"
      "shape.polygon(p, 0.1)",
      "scene:build(structure.sheet { columns = 120, rows = 120 }, { as = 'deformable', mass = 1 })\n"
      "while true do scene:snapshot() end",
      "local s = structure.sheet { columns = 300, rows = 300 } while true do shape.mesh(s) end"};
  for (const std::string& call : calls) {
    INFO(call);
    CHECK(seconds_until_stopped(call) < 0.6);
  }
}

TEST_CASE("a script may join, tie and remove much at once") {
  auto patient = options();
  patient.memory_limit = std::size_t{1} << 30;
  patient.script_limit = 1.0;
  const char* const calls[] = {
      "local p = {} for i = 1, 20000 do p[i] = vec(i * 1e-9, 0, 0) end local s = structure.new { vertices = p }\n"
      "assert(#s:join(s, 1).vertices == 20000)",
      "local p = {} for i = 1, 20000 do p[i] = scene:particle { mass = 1, at = vec(i * 1e-3, 0, 0) } end\n"
      "scene:string(p)",
      "scene:build(structure.geodesic { divisions = 6 }, { as = 'rigid', mass = 1 }).bodies[1]:remove()"};
  for (const char* call : calls) CHECK_NOTHROW(lua::open_scene_text(call, "scene.lua", "", patient));
  CHECK(failure("local p, q = scene:particle {}, scene:particle { at = vec(1, 0, 0) } scene:string { p, q, p }") ==
        "scene.lua:1: string: points 1 and 3 are one particle");
}

TEST_CASE("a script that was stopped in a callback can be stepped on") {
  const auto scene = open(
      "local bad = true scene:on('step', function() while bad do end end) "
      "scene:button('good', function() bad = false end)");
  CHECK_THROWS_WITH(scene->step(), Contains("did not come back"));
  Command press;
  press.kind = Command::Kind::button;
  press.name = "good";
  scene->world().input.commands.push_back(press);
  try {
    scene->step();
  } catch (const Error&) {}
  CHECK_NOTHROW(scene->step());
}

TEST_CASE("memory of a script is capped, with the line") {
  CHECK(failure("local t = {}\nfor i = 1, 1e9 do\n  t[i] = { i }\nend") ==
        "scene.lua:3: Lua's memory is full: the limit is 16 MiB (--memory-limit)");
  CHECK_THAT(failure("local s = 'x'\nwhile true do s = s .. s end"), StartsWith("scene.lua:2: Lua's memory is full"));
  CHECK_THAT(failure("scene:on('step', function()\nlocal s = string.rep('x', 1e9) end)"),
             StartsWith("scene.lua:2: Lua's memory"));
  CHECK(failure("local ok = pcall(string.rep, 'x', 1e9) assert(not ok)") == "");
  auto tiny = options();
  tiny.memory_limit = 1000;
  CHECK_THROWS_AS(lua::open_scene_text("", "scene.lua", "", tiny), UsageError);
  tiny.memory_limit = 20000;
  CHECK_THROWS_AS(lua::open_scene_text("", "scene.lua", "", tiny), Error);
}

TEST_CASE("a script that makes a string longer than 64 MiB is stopped, so that no call goes over one for long") {
  auto roomy = options();
  roomy.memory_limit = std::size_t{1} << 30;
  roomy.script_limit = 60;
  const auto tried = [&](const std::string& source) { lua::open_scene_text(source, "scene.lua", "", roomy); };
  const std::string refused = "scene.lua:2: a string would be longer than 64 MiB: keep its parts in a table";
  for (const char* longer : {"s .. s", "s:rep(2)", "table.concat({ s, s })", "s:gsub('a', ('a'):rep(200), 1)"})
    CHECK_THROWS_WITH(tried(text("local s = ('a'):rep((64 << 20) - 100)\nlocal t = ", longer)), refused);
  CHECK_THROWS_WITH(tried("local s = ('a'):rep(60 << 20)\nlocal t = ('%s%s'):format(s, s)"),
                    "scene.lua:2: format: %s is of at most 64 MiB in all");
  CHECK_THROWS_WITH(tried("local s = ('a'):rep(3 << 20)\nlocal t = ('%q%q'):format(s, s)"),
                    "scene.lua:2: format: %q is of at most 4 MiB in all");
  CHECK_THROWS_WITH(tried("\nstring.pack('c2000000000', '')"),
                    "scene.lua:2: pack: strings are of at most 64 MiB in all");
  CHECK_NOTHROW(tried("assert(string.pack('c4zi1', 'ab', 'c', 7) == 'ab\\0\\0c\\0\\7')"));
  CHECK_NOTHROW(tried("local parts, s = {}, ('a'):rep(60 << 20)\nfor i = 1, 8 do parts[i] = s .. i end"));
  CHECK_NOTHROW(
      tried("local ok, why = pcall(string.rep, 'x', 65 << 20) assert(not ok and why == 'not enough memory')"));
}

TEST_CASE("a script that calls itself for ever is stopped") {
  auto roomy = options();
  roomy.memory_limit = std::size_t{1} << 30;
  roomy.script_limit = 60;
  CHECK_THROWS_WITH(lua::open_scene_text("local function f() return 1 + f() end\nf()", "scene.lua", "", roomy),
                    StartsWith("scene.lua:1: stack overflow"));
  CHECK(failure(
            "local t = setmetatable({}, {}) getmetatable(t).__index = function(t, k) return t[k] end\nlocal x = t.x") !=
        "");
}

TEST_CASE("an error's text is told beyond a byte of zero") {
  CHECK(failure("error 'abc\\0def'") == "scene.lua:1: abc\\x00def");
  CHECK(failure("error { 'abc\\0def' }") == "scene.lua:1: error: { [1] = \"abc\\x00def\" }");
  CHECK(failure("error(('\\0'):rep(200000))").size() == std::string("scene.lua:1: ").size() + 4 * 200000);
  CHECK(failure("read_table 'a\\0b'") == "scene.lua:1: read_table: argument 1, the file, must have no byte of zero");
}

TEST_CASE("an error of a built-in function that a scene gives has the line where it was given") {
  CHECK_THAT(failure("local a = scene:box { size = 1, points = { p = vec(0, 0, 0) } }\n"
                     "local b = scene:box { size = 1, at = vec(0, 3, 0), points = { p = vec(0, 0, 0) } }\n"
                     "scene:screw(a.p, b.p, { lead = print, axis = vec(0, 1, 0) })"),
             StartsWith("scene.lua:3: screw: lead: "));
}

TEST_CASE("a name that is far longer than any is told without a guess") {
  CHECK_THAT(failure("local _ = scene[('x'):rep(1000000)]"), StartsWith("scene.lua:1: scene: ") && !Contains("mean"));
}

TEST_CASE("a script that is nested too deeply to be read is told by its file") {
  CHECK_THAT(failure(std::string(1000, '(')), Contains("scene.lua") && Contains("overflow"));
  std::string labels;
  for (int i = 0; i < 30000; i++) labels += "::e" + std::to_string(i) + "::";
  CHECK(failure(labels) == "scene.lua: C stack overflow");
}
