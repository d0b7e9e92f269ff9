#include "lua/value/tostring.hpp"

#include <cstdio>
#include <string>
#include <utility>

#include "lua/vm/runtime.hpp"
#include "scene/printable.hpp"

namespace pantin::lua {
namespace {

const char numbers_key = 0;  // of the registry's table of what was shown

}  // namespace

void push_shown(lua_State* state) {
  if (lua_rawgetp(state, LUA_REGISTRYINDEX, &numbers_key) != LUA_TNIL) return;
  lua_pop(state, 1);
  lua_newtable(state);
  make_weak(state, "k");
  lua_pushvalue(state, -1);
  lua_rawsetp(state, LUA_REGISTRYINDEX, &numbers_key);
}

namespace {

lua_Integer number_of(lua_State* state, int index) {
  push_shown(state);
  lua_pushvalue(state, index);
  if (lua_rawget(state, -2) == LUA_TNIL) {
    lua_pushvalue(state, index);
    lua_pushinteger(state, ++Runtime::of(state).shown);
    lua_copy(state, -1, -3);
    lua_rawset(state, -4);
  }
  const lua_Integer number = lua_tointeger(state, -1);
  lua_pop(state, 2);
  return number;
}

int to_string(lua_State* state) {
  luaL_checkany(state, 1);
  push_text(state, 1);
  return 1;
}

/// While it lives, the law that runs may show its values: it gets none of the text.
class Showing {
 public:
  explicit Showing(lua_State* state) : runtime_(Runtime::of(state)), law_(std::exchange(runtime_.law, nullptr)) {}
  ~Showing() { runtime_.law = law_; }
  Showing(const Showing&) = delete;
  Showing& operator=(const Showing&) = delete;

 private:
  Runtime& runtime_;
  LawRun* law_;
};

int print(lua_State* state) {
  const Showing showing(state);
  const int count = lua_gettop(state);
  for (int i = 1; i <= count; i++) {
    const std::string s = printable(push_text(state, i));
    if (i > 1) std::fputc('\t', stdout);
    std::fwrite(s.data(), 1, s.size(), stdout);
    lua_pop(state, 1);
  }
  std::fputc('\n', stdout);
  std::fflush(stdout);
  return 0;
}

}  // namespace

std::string_view push_text(lua_State* state, int index) {
  index = lua_absindex(state, index);
  luaL_checkstack(state, 8, nullptr);
  std::size_t size = 0;
  const int type = lua_type(state, index);
  const bool has_address = type == LUA_TTABLE || type == LUA_TFUNCTION || type == LUA_TUSERDATA || type == LUA_TTHREAD;
  if (!has_address || luaL_getmetafield(state, index, "__tostring") != LUA_TNIL) {
    if (has_address) lua_pop(state, 1);
    const char* s = luaL_tolstring(state, index, &size);
    return {s, size};
  }
  const lua_Integer number = number_of(state, index);
  const int named = luaL_getmetafield(state, index, "__name");
  const char* name = named == LUA_TSTRING ? lua_tostring(state, -1) : lua_typename(state, type);
  lua_pushfstring(state, "%s: %I", name, number);
  if (named != LUA_TNIL) lua_remove(state, -2);
  const char* s = lua_tolstring(state, -1, &size);
  return {s, size};
}

void open_tostring(lua_State* state) {
  lua_register(state, "tostring", guard<to_string>);
  lua_register(state, "print", guard<print>);
}

}  // namespace pantin::lua
