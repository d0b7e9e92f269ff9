#include <catch2/catch.hpp>
#include <cstring>
#include <lua.hpp>
#include <memory>
#include <optional>
#include <string>

#include "lua/law/equality.hpp"

using namespace pantin;

namespace {

/// A function of Lua as lua_dump writes it.
std::string dumped(const char* source) {
  const std::unique_ptr<lua_State, void (*)(lua_State*)> state(luaL_newstate(), lua_close);
  REQUIRE(luaL_loadbufferx(state.get(), source, std::strlen(source), "=text", "t") == LUA_OK);
  std::string bytes;
  lua_dump(
      state.get(),
      [](lua_State*, const void* part, std::size_t size, void* to) {
        static_cast<std::string*>(to)->append(static_cast<const char*>(part), size);
        return 0;
      },
      &bytes, 0);
  return bytes;
}

std::optional<int> line_of(const std::string& function) {
  return lua::line_of_equality(function, LUA_VERSION_RELEASE_NUM);
}

}  // namespace

TEST_CASE("an equality test is found in a function of Lua, and only where there is one") {
  CHECK(line_of(dumped("local a, b = ...\nreturn a == b")) == 2);
  CHECK(line_of(dumped("local a = ...\n\nreturn a ~= 1")) == 3);
  CHECK(line_of(dumped("local a = ...\nreturn a == 0.5")) == 2);
  CHECK(line_of(dumped("local function inner(a)\n  return a == 1e300\nend\nreturn inner")) == 2);
  CHECK(line_of(dumped("local a = ...\nreturn a == 'text'")) == 0);
  CHECK(line_of(dumped("local a, b = ...\nreturn a < b and a * 2.5 or b // 1")) == 0);
}

TEST_CASE("whether a function tests for equality is not told of a release of Lua whose functions are not known") {
  const std::string function = dumped("local a, b = ...\nreturn a == b");
  CHECK(lua::line_of_equality(function, 50404) == 2);
  for (const int release : {50300, 50399, 50407, 50500}) CHECK_FALSE(lua::line_of_equality(function, release));
  std::string other = function;
  other[4] = '\x55';
  CHECK_FALSE(line_of(other));
  CHECK_FALSE(line_of(""));
}

TEST_CASE("a function that is cut off or garbled is read within its bounds") {
  const std::string function = dumped(R"(local a, b = ...
    local function inner(c) return c == 1e300 and "a text" or c == 3 end
    return inner(a) == b, function() return a end)");
  REQUIRE(line_of(function) == 3);
  for (std::size_t size = 0; size < function.size(); size++) CHECK_FALSE(line_of(function.substr(0, size)));
  for (std::size_t i = 15; i < function.size(); i++)
    for (const int bits : {0x01, 0x40, 0x80, 0xff}) {
      std::string garbled = function;
      garbled[i] = static_cast<char>(garbled[i] ^ bits);
      CHECK_NOTHROW(line_of(garbled));
    }
}
