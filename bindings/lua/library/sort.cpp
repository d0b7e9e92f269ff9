// `table.sort` in an order that is the same in every run: Lua's own takes its pivots from the clock where a list is hard to
// sort, so that what compares as equal, or inconsistently, lands elsewhere each time. This one is stable.
#include <algorithm>
#include <lua.hpp>

#include "lua/library/sandbox.hpp"
#include "lua/value/values.hpp"
#include "lua/vm/guard.hpp"
#include "lua/vm/watchdog.hpp"

namespace pantin::lua {
namespace {

constexpr int sorted = 1, less = 2, from = 3, to = 4;  // places on the stack

/// Throws Error unless `<` can compare the two values at the top; Lua's own message would not name the line.
void require_order(lua_State* state) {
  const int a = lua_type(state, -2), b = lua_type(state, -1);
  if (a == b && (a == LUA_TNUMBER || a == LUA_TSTRING)) return;
  if (luaL_getmetafield(state, -2, "__lt") != LUA_TNIL || luaL_getmetafield(state, -1, "__lt") != LUA_TNIL)
    return lua_pop(state, 1);
  throw Error(text("sort: cannot compare ", kind_of_value(state, -2), " with ", kind_of_value(state, -1),
                   "; give a function that tells which comes first"));
}

/// Whether element `i` of the table at `from` must stand before its element `j`.
bool before(lua_State* state, lua_Integer i, lua_Integer j) {
  const bool own_order = !lua_isnil(state, less);
  if (own_order) lua_pushvalue(state, less);
  lua_rawgeti(state, from, i);
  lua_rawgeti(state, from, j);
  if (own_order)
    lua_call(state, 2, 1);
  else
    require_order(state);
  const bool answer = own_order ? lua_toboolean(state, -1) != 0 : lua_compare(state, -2, -1, LUA_OPLT) != 0;
  lua_settop(state, to);
  return answer;
}

/// Merges the sorted runs [begin, middle) and [middle, end) of the table at `from` into the one at `to`.
void merge(lua_State* state, lua_Integer begin, lua_Integer middle, lua_Integer end, Interruptible& loop) {
  lua_Integer i = begin, j = middle;
  for (lua_Integer k = begin; k < end; k++) {
    loop.count();
    const bool right = i == middle || (j < end && before(state, j, i));
    lua_rawgeti(state, from, right ? j++ : i++);
    lua_rawseti(state, to, k);
  }
}

/// table.sort(list[, less]): merges runs of 1, 2, 4 … elements.
int sort(lua_State* state) {
  luaL_checktype(state, sorted, LUA_TTABLE);
  if (!lua_isnoneornil(state, less)) luaL_checktype(state, less, LUA_TFUNCTION);
  lua_settop(state, less);
  const lua_Integer count = luaL_len(state, sorted);
  luaL_argcheck(state, count < (lua_Integer{1} << 30), sorted, "the list is too long");
  constexpr lua_Integer at_once = 1 << 20;  // room for so many: memory is slow to come, and nobody stops it meanwhile
  for (int i = 0; i < 2; i++) lua_createtable(state, static_cast<int>(std::min(count, at_once)), 0);
  Interruptible loop;
  for (lua_Integer i = 1; i <= count; i++) {
    loop.count();
    lua_geti(state, sorted, i);
    lua_rawseti(state, from, i);
  }
  for (lua_Integer run = 1; run < count; run *= 2) {
    for (lua_Integer begin = 1; begin <= count; begin += 2 * run)
      merge(state, begin, std::min(begin + run, count + 1), std::min(begin + 2 * run, count + 1), loop);
    lua_insert(state, from);  // what was merged is merged next
  }
  for (lua_Integer i = 1; i <= count; i++) {
    loop.count();
    lua_rawgeti(state, from, i);
    lua_seti(state, sorted, i);
  }
  return 0;
}

}  // namespace

void open_sort(lua_State* state) {
  lua_getglobal(state, "table");
  lua_pushcfunction(state, guard<sort>);
  lua_setfield(state, -2, "sort");
  lua_pop(state, 1);
}

}  // namespace pantin::lua
