// The part of Lua's table library whose loops `__len` or a wide range can make endless: it asks the clock.
#include <limits>

#include "lua/library/sandbox.hpp"
#include "lua/vm/guard.hpp"
#include "lua/vm/watchdog.hpp"

namespace pantin::lua {
namespace {

constexpr int list = 1;  // place on the stack

lua_Integer length_of(lua_State* state) {
  luaL_checktype(state, list, LUA_TTABLE);
  return luaL_len(state, list);
}

void copy(lua_State* state, int from, lua_Integer i, int to, lua_Integer j) {
  lua_geti(state, from, i);
  lua_seti(state, to, j);
}

/// table.insert(list[, place], value)
int insert(lua_State* state) {
  const lua_Integer end = length_of(state) + 1;
  const int count = lua_gettop(state);
  require(count == 2 || count == 3, "wrong number of arguments to 'insert'");
  lua_Integer place = end;
  if (count == 3) {
    place = luaL_checkinteger(state, 2);
    luaL_argcheck(state, place >= 1 && place <= end, 2, "position out of bounds");
  }
  Interruptible loop;
  for (lua_Integer i = end; i > place; i--) {
    loop.count();
    copy(state, list, i - 1, list, i);
  }
  lua_seti(state, list, place);
  return 0;
}

/// table.remove(list[, place])
int remove(lua_State* state) {
  const lua_Integer size = length_of(state);
  lua_Integer place = luaL_optinteger(state, 2, size);
  luaL_argcheck(state, place == size || (place >= 1 && place - 1 <= size), 2, "position out of bounds");
  lua_geti(state, list, place);
  Interruptible loop;
  for (; place < size; place++) {
    loop.count();
    copy(state, list, place + 1, list, place);
  }
  lua_pushnil(state);
  lua_seti(state, list, place);
  return 1;
}

/// table.move(list, first, last, place[, other])
int move(lua_State* state) {
  luaL_checktype(state, list, LUA_TTABLE);
  const lua_Integer first = luaL_checkinteger(state, 2), last = luaL_checkinteger(state, 3),
                    place = luaL_checkinteger(state, 4), most = std::numeric_limits<lua_Integer>::max();
  const int other = lua_isnoneornil(state, 5) ? list : 5;
  luaL_checktype(state, other, LUA_TTABLE);
  lua_pushvalue(state, other);
  if (last < first) return 1;
  luaL_argcheck(state, first > 0 || last < most + first, 3, "too many elements to move");
  const lua_Integer count = last - first + 1;
  luaL_argcheck(state, place <= most - count + 1, 4, "destination wrap around");
  const bool apart = other != list && !lua_rawequal(state, list, other);
  const bool forward = place > last || place <= first || apart;
  Interruptible loop;
  for (lua_Integer k = 0; k < count; k++) {
    loop.count();
    const lua_Integer i = forward ? k : count - 1 - k;
    copy(state, list, first + i, other, place + i);
  }
  return 1;
}

/// table.concat(list[, separator[, first[, last]]])
int concat(lua_State* state) {
  const lua_Integer size = length_of(state);
  std::size_t length = 0;
  const char* separator = luaL_optlstring(state, 2, "", &length);
  const lua_Integer first = luaL_optinteger(state, 3, 1), last = luaL_optinteger(state, 4, size);
  lua_settop(state, 4);
  Interruptible loop;
  luaL_Buffer buffer;
  luaL_buffinit(state, &buffer);
  for (lua_Integer i = first; i <= last; i++) {
    lua_geti(state, list, i);
    require(lua_isstring(state, -1) != 0, "invalid value (at index ", i, ") in table for 'concat'");
    loop.count_bytes(lua_rawlen(state, -1) + length);
    luaL_addvalue(&buffer);
    if (i == last) break;  // which may be the largest number
    luaL_addlstring(&buffer, separator, length);
  }
  luaL_pushresult(&buffer);
  return 1;
}

}  // namespace

void open_tables(lua_State* state) {
  const luaL_Reg replaced[] = {{"insert", guard<insert>},
                               {"remove", guard<remove>},
                               {"move", guard<move>},
                               {"concat", guard<concat>},
                               {nullptr, nullptr}};
  lua_getglobal(state, "table");
  luaL_setfuncs(state, replaced, 0);
  lua_pop(state, 1);
}

}  // namespace pantin::lua
