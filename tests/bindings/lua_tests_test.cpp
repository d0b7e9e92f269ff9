// The runner of tests written in Lua, and what reads files: on a folder of its own.
#include "lua/test/tests.hpp"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "bindings/lua_support.hpp"
#include "lua/scene/open.hpp"
#include "scene/errors.hpp"
#include "support/process.hpp"

using namespace pantin;
using namespace pantin::lua_tests;
using Catch::Contains;

namespace {

struct Folder : support::Folder {
  std::string write(const std::string& name, const std::string& content) const {
    const std::filesystem::path file = path / name;
    std::filesystem::create_directories(file.parent_path());
    support::write_file(file, content);
    return file;
  }
};

struct Ran {
  lua::TestOutcome outcome;
  std::string printed;
};

Ran run(const std::vector<std::string>& paths) {
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> out(std::tmpfile(), std::fclose);
  Ran ran;
  ran.outcome = lua::run_tests(paths, options(), out.get());
  std::rewind(out.get());
  for (int c = std::fgetc(out.get()); c != EOF; c = std::fgetc(out.get())) ran.printed += static_cast<char>(c);
  return ran;
}

}  // namespace

TEST_CASE("passing and failing tests are told apart, with file, line and message") {
  const Folder folder;
  folder.write("a_test.lua", R"lua(test("good", function() expect(1):equal(1) end)
test("bad", function()
  expect(2):near(1, 0.5)
end)
test("unknown", function() expect(1):nearly(1) end)
test("endless", function() while true do end end)
test("after", function() expect(vec(1, 2, 3)):near(vec(1, 2, 3.1), 0.2) expect(true):is_true() expect(1):below(2) expect(2):above(1) end))lua");
  folder.write("deeper/b_test.lua", "local x = nil + 1");
  folder.write("empty_test.lua", "");
  std::filesystem::create_symlink("loop_test.lua", folder.path / "loop_test.lua");
  const Ran ran = run({folder.path});
  CHECK(ran.outcome.passed == 2);
  CHECK(ran.outcome.failed == 5);
  CHECK_THAT(ran.printed,
             Contains("FAILED a_test.lua:2: bad\n  a_test.lua:3: expected 1 within 0.5, got 2, which is 1 off"));
  CHECK_THAT(ran.printed, Contains("a_test.lua:5: expect: unknown expectation 'nearly'"));
  CHECK_THAT(ran.printed, Contains("a_test.lua:6: the script did not come back"));
  CHECK_THAT(ran.printed, Contains("b_test.lua:1: attempt to perform arithmetic on a nil value"));
  CHECK_THAT(ran.printed, Contains("empty_test.lua: has no test"));
  CHECK_THROWS_AS(run({folder / "nothing"}), UsageError);
}

TEST_CASE("tests open scenes, step them and read them") {
  const Folder folder;
  folder.write("scene.lua", R"lua(
    local v = scene:param("v", 1, { max = 5 })
    local p = scene:particle { velocity = vec(v, 0, 0), name = "p" }
    scene:probe("x", function() return p.position.x end)
    scene:result("v", v))lua");
  const Ran ran = run({folder.write("open_test.lua", R"lua(
    test("a scene moves", function()
      local s = open("scene.lua", { v = 2, ["scene.gravity"] = vec(0, 0, 0) })
      s:advance(0.5) s:step()
      expect(s.time):near(0.5 + 1 / 240, 1e-12)
      expect(s:read "x"):near(2 * s.time, 1e-12)
      expect(s:result "v"):equal(2)
      expect(s:find "p"):equal(s.particles[1])
      expect(s.energy.kinetic):near(2, 1e-12)
      expect(s.stats.steps):equal(121)
      expect(function() s:read "y" end):fails "no probe 'y'"
      expect(function() open("scene.lua", { v = 6 }) end):fails "at most 5"
      expect(function() open("nowhere.lua") end):fails "no such file"
    end)
    test("two scenes live side by side", function()
      local a, b = open_text "scene:particle { name = 'p' }", open_text "scene:particle { name = 'p' }"
      expect(a:find "p" ~= b:find "p"):is_true()
      a:find("p"):remove()
      expect(b:find("p").alive):is_true()
      expect(#a.particles):equal(0)
    end)
    test("errors of a scene come with its line", function()
      expect(function() open_text "\nscene:hinge(1)" end):fails "text.lua:2: hinge: argument 1"
      local s = open_text "scene:on('step', function() error 'in step' end)"
      expect(function() s:step() end):fails "text.lua:1: in step"
    end)
    test("the time of the engine is not the script's", function()
      local s = open_text "for i = 1, 100 do scene:particle { at = vec(i, 0, 0) } end"
      s:advance(60)
    end))lua")});
  INFO(ran.printed);
  CHECK(ran.outcome.passed == 4);
  CHECK(ran.outcome.failed == 0);
}

TEST_CASE("require finds the scene's own files once, and tells of errors in them") {
  const Folder folder;
  folder.write("parts/wheel.lua", "count = (count or 0) + 1 return { radius = 2 }");
  folder.write("bad.lua", "\nlocal x = nil + 1");
  folder.write("round.lua", "require 'round'");
  const auto run_scene = [&](const std::string& source) {
    return lua::open_scene(folder.write("scene.lua", source), options());
  };
  CHECK_NOTHROW(run_scene(
      "local a, b = require 'parts.wheel', require 'parts/wheel' assert(a == b and a.radius == 2 and count == 1)"));
  CHECK_THROWS_WITH(run_scene("require 'bad'"), Contains("bad.lua:2: attempt to perform arithmetic"));
  CHECK_THROWS_WITH(run_scene("require 'round'"), Contains("round.lua:1: require: 'round' requires itself"));
}

TEST_CASE("a byte order mark before a scene, a module or a test is skipped, before a line for the shell, too") {
  const Folder folder;
  const std::string mark = "\xef\xbb\xbf";
  folder.write("marked.lua", mark + "return 7");
  const auto opened = lua::open_scene(
      folder.write("scene.lua", mark + "#!/usr/bin/env pantin\nscene:result('x', require 'marked')"), options());
  CHECK(std::get<double>(opened->results().at("x")) == 7.0);
  CHECK(std::get<double>(lua::open_state(opened->state(), "state", {})->results().at("x")) == 7.0);
  CHECK_THROWS_WITH(lua::open_scene(folder.write("bad.lua", mark + "\nlocal x = = 1"), options()),
                    "bad.lua:2: unexpected symbol near '='");
  const std::string test = folder.write("marked_test.lua", mark + "test('a', function() end)");
  std::FILE* const out = std::fopen("/dev/null", "w");
  REQUIRE(out != nullptr);
  CHECK(lua::run_tests({test}, options(), out).passed == 1);
  std::fclose(out);
}

TEST_CASE("tables of numbers are read from the scene's folder") {
  const Folder folder;
  folder.write("plain.csv", "1,2\n\n# note\n-3e2, +4.5\r\n");
  folder.write("named.csv", "time, \"height\"\n0,1\n1,0.5\n");
  folder.write("bad.csv", "a,b\n1,2\n3,x\n");
  folder.write("ragged.csv", "1,2\n3\n");
  const auto run_scene = [&](const std::string& source) {
    return lua::open_scene(folder.write("scene.lua", source), options());
  };
  CHECK_NOTHROW(run_scene(
      "local t = read_table 'plain.csv' assert(#t == 2 and t[1][2] == 2 and t[2][1] == -300 and t[2][2] == 4.5)"));
  CHECK_NOTHROW(run_scene(
      "local t = read_table 'named.csv' assert(#t == 2 and t[2].height == 0.5 and t[2][1] == 1 and t[1].time == 0)"));
  CHECK_THROWS_WITH(run_scene("read_table 'bad.csv'"),
                    "scene.lua:1: read_table: bad.csv:3: column 2 must be a number, got 'x'");
  CHECK_THROWS_WITH(run_scene("read_table 'ragged.csv'"),
                    Contains("ragged.csv:2: must have 2 columns like the first line, got 1"));
  CHECK_THROWS_WITH(run_scene("read_table 'none.csv'"), Contains("there is no file"));
  CHECK_THROWS_WITH(run_scene("read_table '../x.csv'"), Contains("must be a file below the scene's folder"));
}

TEST_CASE("a link does not lead a scene's files out of its folder") {
  const Folder folder, other;
  other.write("secret.csv", "1,2\n");
  other.write("secret.lua", "return 1");
  other.write("secret.xyz", "1\n\nC 0 0 0\n");
  std::filesystem::create_directory_symlink(other.path, folder.path / "out");
  folder.write("own.csv", "1,2\n");
  std::filesystem::create_symlink("own.csv", folder.path / "same.csv");
  const auto run_scene = [&](const std::string& source) {
    return lua::open_scene(folder.write("scene.lua", source), options());
  };
  CHECK_THROWS_WITH(run_scene("read_table 'out/secret.csv'"), Contains("leads out of the scene's folder"));
  CHECK_THROWS_WITH(run_scene("require 'out.secret'"), Contains("leads out of its folder"));
  CHECK_THROWS_WITH(run_scene("structure.molecule 'out/secret.xyz'"), Contains("leads out of its folder"));
  CHECK_NOTHROW(run_scene("assert(#read_table 'same.csv' == 1)"));
}

TEST_CASE("a scene is the same in every run, to the last bit") {
  const std::string source = R"lua(
    local t = { one = 1, two = 2, three = 3, four = 4, five = 5 }
    for name, n in pairs(t) do
      scene:particle { name = name, at = vec(math.random(), math.sin(n), n ^ 0.3), velocity = vec(n, 0, 0) }
    end
    local s = ""
    for _, p in ipairs(scene.particles) do s = s .. p.name .. string.format(" %a %a %a ", p.position.x, p.position.y, p.position.z) end
    scene:result("x", s))lua";
  CHECK(word(source) == word(source));
  CHECK_THAT(word(source), Catch::StartsWith("five ") && Contains("four") && Contains("two"));
}

TEST_CASE("a test that another declares runs after it") {
  const Folder folder;
  folder.write("a_test.lua", R"lua(test("outer", function()
  for i = 1, 100 do test("inner " .. i, function() expect(i):below(100) end) end
end))lua");
  const Ran ran = run({folder.path});
  CHECK(ran.outcome.passed == 100);
  CHECK_THAT(ran.printed, Contains("FAILED a_test.lua:2: inner 100"));
}
