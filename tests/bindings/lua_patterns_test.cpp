// Our own matcher of patterns beside the string library's own, which no scene can reach.
#include <array>
#include <catch2/catch.hpp>

#include "bindings/lua_support.hpp"
#include "lua/library/sandbox.hpp"

using namespace pantin;
using namespace pantin::lua_tests;
using Catch::Contains;
using Catch::StartsWith;

namespace {

/// Runs a text that has the library's own functions as `original`; it must not raise.
void run_beside_original(const std::string& source) {
  Random random{8, 0};
  lua::Runtime runtime({60.0, std::size_t{1} << 28}, lua::sandbox);
  runtime.random = &random;
  runtime.run([&](lua_State* state) {
    luaopen_string(state);
    lua_setglobal(state, "original");
    runtime.load(state, source, "beside.lua");
    lua_call(state, 0, 0);
  });
}

const std::string helpers = R"lua(
  local function show(...)
    local values = table.pack(...)
    for i = 1, values.n do
      local text = original.gsub(tostring(values[i]), "^beside%.lua:%d+: ", "")
      values[i] = (math.type(values[i]) or type(values[i])) .. " " .. original.format("%q", text)
    end
    return table.concat(values, " ", 1, values.n)
  end
  local function same(name, ...)
    local ours, theirs = show(pcall(string[name], ...)), show(pcall(original[name], ...))
    if ours ~= theirs then
      error(name .. "(" .. show(...) .. ") gives " .. ours .. " and must give " .. theirs)
    end
  end
  local function all(name, s, p)
    local list = {}
    for a, b, c in name(s, p) do list[#list + 1] = tostring(a) .. ":" .. tostring(b) .. ":" .. tostring(c) end
    return table.concat(list, " ")
  end
)lua";

}  // namespace

TEST_CASE("patterns: what the manual says") {
  CHECK(failure(R"lua(
    local function is(wanted, ...)
      local got = {}
      for i, v in ipairs { ... } do got[i] = tostring(v) end
      local text = table.concat(got, " ")
      if text ~= wanted then error("'" .. text .. "' must be '" .. wanted .. "'", 2) end
    end
    is("3 5", ("a.cde"):find("cde"))
    is("2 2", ("a.b"):find(".", 2, true))
    is("7 7 k", ("hello key"):find("(k)"))
    is("1 0", ("abc"):find(""))
    is("4 3", ("abc"):find("", 4))
    is("nil", tostring((("abc"):find("", 5))))
    is("3 3", ("aba"):find("a", -1))
    is("key value", ("key = value"):match("^(%w+)%s*=%s*(%w+)$"))
    is("(a(b)c)", ("x(a(b)c)d"):match("%b()"))
    is("THE (quick) fox", (("THE (quick) fox"):gsub("%f[%a]%u+%f[%A]", "THE")))
    is("1 4", ("abc"):match("()abc()"))
    is("' q", ([[say 'q"' "r"]]):match([[(['"])(%w).-%1]]))
    is("hello hello world world 2", ("hello world"):gsub("%w+", "%0 %0"))
    is("world hello 1", ("hello world"):gsub("(%w+) (%w+)", "%2 %1"))
    is("hexxo 2", ("hello"):gsub("l", "x"))
    is("hexlo 1", ("hello"):gsub("l", "x", 1))
    is("-a-b- 3", ("ab"):gsub("", "-"))
    is("100% 1", ("x"):gsub("x", "100%%"))
    is("4+5 = 9 1", ("4+5 = $sum"):gsub("%$(%w+)", { sum = 9 }))
    is("a b 1", ("a b"):gsub("b", function() end))
    is("x[1]y[2] 2", ("xy"):gsub("()%w", function(i) return ("xy"):sub(i, i) .. "[" .. i .. "]" end))
    local words = {}
    for word, at in ("one two"):gmatch("(%a+)()") do words[#words + 1] = word .. at end
    is("one4 two8", table.unpack(words)))lua") == "");
}

TEST_CASE("patterns: malformed ones are told, with the line") {
  const std::pair<const char*, const char*> cases[] = {
      {"('a'):find('[a')", "malformed pattern (missing ']')"},
      {"('a'):find('%')", "malformed pattern (ends with '%')"},
      {"('a'):find('%bx')", "missing arguments to '%b'"},
      {"('a'):find('%fa')", "missing '[' after '%f'"},
      {"('a'):find('(a')", "unfinished capture"},
      {"('a'):match('a)')", "invalid pattern capture"},
      {"('a'):find('%1')", "invalid capture index %1"},
      {"('a'):find(('()'):rep(33))", "too many captures"},
      {"('a'):rep(300):find(('a?'):rep(300))", "pattern too complex"},
      {"('a'):gsub('a', '%2')", "invalid capture index %2"},
      {"('a'):gsub('a', '%x')", "invalid use of '%' in replacement string"},
      {"('a'):gsub('a', function() return {} end)", "invalid replacement value (a table)"},
      {"('a'):gsub('a', true)", "bad argument #2 to 'gsub' (string/function/table expected, got boolean)"},
      {"('a'):find()", "bad argument #1 to 'find' (string expected, got no value)"},
  };
  for (const auto& [call, says] : cases) CHECK_THAT(failure(call), StartsWith("scene.lua:1: ") && Contains(says));
}

TEST_CASE("patterns: every character is of the same classes as in the library") {
  run_beside_original(helpers + R"lua(
    for code = 0, 255 do
      local c = string.char(code)
      for class in ("acdglpsuwxz"):gmatch(".") do
        for _, item in ipairs { class, class:upper() } do
          same("find", c, "%" .. item)
          same("find", c, "[%" .. item .. "]")
          same("find", c, "[^%" .. item .. "_]")
        end
      end
      same("find", "a" .. c .. "b", "[" .. c .. "]")
      same("find", "%b[" .. c .. "-" .. "]", "%" .. c)
    end)lua");
}

TEST_CASE("an empty text of C is an empty text of Lua, wherever it lies") {
  lua::Runtime runtime({60.0, std::size_t{1} << 28}, lua::sandbox);
  runtime.run([&](lua_State* state) {
    const std::array<char, 256> empty{};  // Lua keeps texts of C by where they lie
    for (const char& text : empty) {
      lua_pushstring(state, &text);
      CHECK(lua_rawlen(state, -1) == 0);
      lua_pop(state, 1);
    }
  });
}

TEST_CASE("patterns: any pattern on any text gives what the library gives") {
  run_beside_original(helpers + R"lua(
    local parts = { "a", "b", "ab", ".", "%a", "%A", "[ab]", "[^a]", "[a-c]", "[]]", "[^]]", "[%]a-]", "[a-]", "(", ")", "()",
      "(a", "b)", "(.-)", "(a*)", "%b()", "%bab", "%f[a]", "%f[%W]", "%1", "%2", "$", "^", "*", "+", "-", "?", "%", "[", "]",
      "\0", "%0", "[\0-a]", "%.", "%%", "c" }
    local letters = { "a", "b", "c", "(", ")", "]", "-", "%", "\0", ".", "\xe9", "ab", "aa" }
    local forms = { "<%0>", "%1", "%2%1", "%%", "x", "", "%", "%a" }
    local function draw(list, most)
      local s = ""
      for _ = 1, math.random(0, most) do s = s .. list[math.random(#list)] end
      return s
    end
    for _ = 1, 20000 do
      local s, p = draw(letters, 8), draw(parts, 5)
      local init = math.random(-10, 10)
      same("find", s, p) same("find", s, p, init) same("find", s, p, init, true) same("match", s, p, init)
      same("gsub", s, p, forms[math.random(#forms)], math.random(-1, 4))
      same("gsub", s, p, function(a, b) return b or a ~= "a" and a end)
      same("gsub", s, p, { a = "A", b = false, ab = 7, [1] = "one" })
      local ok, ours = pcall(all, string.gmatch, s, p)
      local fine, theirs = pcall(all, original.gmatch, s, p)
      if ok ~= fine or ok and ours ~= theirs then error("gmatch of '" .. p .. "' on '" .. s .. "': " .. ours .. " " .. theirs) end
    end)lua");
}

TEST_CASE("patterns: repetition and tables do what the library does") {
  run_beside_original(helpers + R"lua(
    for _, n in ipairs { -1, 0, 1, 2, 5 } do
      for _, s in ipairs { "", "a", "ab\0" } do
        same("rep", s, n) same("rep", s, n, "") same("rep", s, n, ", ")
      end
    end
    same("rep", "abc", 500000, "-") same("rep", ("x"):rep(1500000), 3, ", ")
    same("rep", "x", 1 << 62))lua");
  CHECK(word(R"lua(
    local t = { 1, 2, 3 }
    table.insert(t, 4) table.insert(t, 1, 0) table.insert(t, 3, 1.5)
    assert(table.remove(t) == 4 and table.remove(t, 1) == 0 and table.remove({}) == nil and table.remove({}, 0) == nil)
    table.move(t, 1, 3, 2) table.move(t, 2, 3, 1)
    scene:result("x", table.concat(t, " ") .. " " .. #table.move(t, 1, 4, 1, {})))lua") == "1 1.5 1.5 2 4");
  CHECK_THAT(failure("table.insert({ 1 }, 5, 2)"), StartsWith("scene.lua:1: ") && Contains("out of bounds"));
  CHECK_THAT(failure("table.remove({ 1 }, 5)"), StartsWith("scene.lua:1: ") && Contains("out of bounds"));
  CHECK_THAT(failure("table.insert({})"), StartsWith("scene.lua:1: wrong number of arguments"));
  CHECK_THAT(failure("table.move({}, 1, math.maxinteger, 2)"), StartsWith("scene.lua:1: ") && Contains("wrap around"));
}
