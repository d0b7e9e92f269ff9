#include "scene/printable.hpp"

#include <catch2/catch.hpp>

#include "bindings/program_support.hpp"
#include "player/svg.hpp"

using namespace pantin::support;
using Catch::Contains;
using pantin::printable;

TEST_CASE("printable: letters of all languages, tabs and new lines stay as they are") {
  for (const char* text : {"", "a\tb\n", "Ångström Ω", "粒子", "🎈", "\xc2\xa0", "\xf4\x8f\xbf\xbf"})
    CHECK(printable(text) == text);
}

TEST_CASE("printable: what would command a terminal is shown as its code") {
  CHECK(printable("\x1b[2J") == "\\x1b[2J");
  CHECK(printable("a\rb\a\b\x7f") == "a\\x0db\\x07\\x08\\x7f");
  CHECK(printable(std::string("\0", 1)) == "\\x00");
  CHECK(printable("\xc2\x9b"
                  "31m") == "\\xc2\\x9b31m");
}

TEST_CASE("printable: bytes that are no UTF-8 are shown as theirs") {
  CHECK(printable("\x9b"
                  "31m") == "\\x9b31m");
  CHECK(printable("caf\xe9") == "caf\\xe9");
  CHECK(printable("\xe7\xb2") == "\\xe7\\xb2");
  CHECK(printable("\xc0\x9b\xf8") == "\\xc0\\x9b\\xf8");
}

TEST_CASE("printable: what turns the direction of reading or separates lines is shown as its code") {
  for (const char* code : {"\u061c", "\u200e", "\u200f", "\u2028", "\u2029", "\u202a", "\u202e", "\u2066", "\u2069"})
    CHECK_THAT(printable(code), Catch::StartsWith("\\x") && !Contains(code));
  CHECK(printable("a\u202eb") == "a\\xe2\\x80\\xaeb");
}

TEST_CASE("printable: letters written too long, halves of pairs and what is beyond all letters are no UTF-8") {
  for (const char* bytes :
       {"\xef\xbf\xbe", "\xef\xbf\xbf", "\xe0\x80\x80", "\xf0\x80\x80\x80", "\xed\xa0\x80", "\xf4\x90\x80\x80"})
    CHECK_THAT(printable(bytes), Catch::StartsWith("\\x") && !Contains(bytes));
}

TEST_CASE("printable: a picture's texts are XML whatever bytes they have") {
  CHECK(pantin::player::svg_escaped("p\x1b[32m <\xff> & q") == "p\\x1b[32m &lt;\\xff&gt; &amp; q");
}

TEST_CASE("printable: nothing that a scene, a test or an option says reaches the terminal raw") {
  Folder folder;
  const std::string hostile = R"(
    print("\27[2J", setmetatable({}, { __tostring = function() return "\27[3J" end }))
    scene.title = "\27]0;title\7"
    scene:probe("\27[4m", function() return 1 end)
    scene:result("\27[5m", "\27[6m")
    scene:after(100, function() end)
    scene:particle { at = vec(0, 0, 0), name = "\27[7m" }
  )";
  write_file(folder / "hostile.lua", hostile);
  write_file(folder / "broken.lua", hostile + "error '\\27[8m'");
  write_file(folder / "stops.lua", "scene:particle() scene:at(0.01, function() error '\\27[2J' end)");
  write_file(folder / "hostile_test.lua", "test('\\27[2J', function() expect('\\27[3J'):equal(1) error '\\27[4m' end)");
  const std::vector<std::vector<std::string>> uses = {
      {"run", "hostile.lua", "--until", "0.1"},
      {"run", "broken.lua", "--until", "0.1"},
      {"test", "hostile_test.lua"},
      {"test", "soak", "--scene", "stops.lua", "--steps", "100"},
      {"test", "fuzz", "broken.lua"},
      {"run", "\x1b[2J.lua"},
      {"run", "hostile.lua", "--set", "\x1b[2J=1"},
      {"run", "hostile.lua", "--\x1b[2J"},
      {"play", "\x1b[2J"},
      {"replay", "hostile.lua\x1b[2J"},
      {"\x1b[2J"},
  };
  for (const auto& arguments : uses) {
    const Finished done = use(folder, arguments);
    INFO(arguments[0]);
    CHECK_THAT(done.out + done.err, !Contains("\x1b") && !Contains("\a") && Contains("\\x1b["));
  }
}
