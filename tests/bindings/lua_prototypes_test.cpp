// Functions of a text, cut out of what Lua dumps.
#include "lua/vm/prototypes.hpp"

#include "bindings/lua_support.hpp"
#include "lua/law/force_library.hpp"
#include "lua/library/sandbox.hpp"
#include "lua/value/values.hpp"
#include "lua/vm/runtime.hpp"

using namespace pantin;
using Catch::Contains;

TEST_CASE("prototypes: each function of a text is found by what it dumps, and runs when it is loaded from that") {
  lua::Runtime runtime({0.0, std::size_t{16} << 20}, lua::sandbox);
  const lua::SourceText chunk{"scene.lua", R"(#!/usr/bin/env pantin
    local x <const>, long = 3, string.rep("long", 50)
    function f(a, ...) return a + 1.5, "short", ... end
    local function g() local n = 2^40 return function(b) n = n + b return n, x, long, nil, true, false end end
    for i = 1, 3 do h = function() goto out ::out:: return i end end
    k = g())"};
  runtime.run([&](lua_State* state) {
    const std::vector<std::string> cut = lua::prototypes(state, chunk);
    REQUIRE(cut.size() == 5);
    lua::load_text(state, chunk);
    lua_call(state, 0, 0);
    for (const auto& [name, number] : {std::pair("f", 1), std::pair("k", 3), std::pair("h", 4)}) {
      lua_getglobal(state, name);
      CHECK(lua::dumped(state) == cut[static_cast<std::size_t>(number)]);
      lua_pop(state, 1);
    }
    REQUIRE(luaL_loadbufferx(state, cut[1].data(), cut[1].size(), "=?", "b") == LUA_OK);
    lua_pushnumber(state, 1.0);
    lua_call(state, 1, 2);
    CHECK(lua_tonumber(state, -2) == 2.5);
    CHECK(std::string(lua_tostring(state, -1)) == "short");
    lua_settop(state, 0);
  });
}

TEST_CASE("values: what functions of the library keep says what it is, and is taken for no vec and no thing") {
  lua::Runtime runtime({0.0, std::size_t{16} << 20}, lua::sandbox);
  runtime.run([&](lua_State* state) {
    lua_newtable(state);
    lua::add_library_laws(state);
    lua_getfield(state, -1, "spring");
    REQUIRE(lua_getupvalue(state, -1, 2) != nullptr);
    CHECK(lua::tag_of(state, -1) == lua::Tag::known_laws);
    lua_settop(state, 0);
  });
}
