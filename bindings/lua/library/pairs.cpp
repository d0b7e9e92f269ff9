// `pairs` and `next` in an order that is the same in every run: Lua's own order of strings differs from run to run.
#include <algorithm>
#include <string_view>
#include <tuple>
#include <vector>

#include "lua/library/sandbox.hpp"
#include "lua/value/copies.hpp"
#include "lua/value/ref.hpp"
#include "lua/vm/guard.hpp"
#include "lua/vm/watchdog.hpp"

namespace pantin::lua {
namespace {

/// Numbers, then strings, then false and true, then things in the order of making.
struct Key {
  int rank = 0;
  long double number = 0;  // holds any integer and any double exactly
  std::string_view string;
  std::uint64_t serial = 0;
  lua_Integer index = 0;

  bool operator<(const Key& other) const {
    return std::tie(rank, number, string, serial) < std::tie(other.rank, other.number, other.string, other.serial);
  }
};

Key key_at(lua_State* state, int index) {
  Key key;
  switch (lua_type(state, index)) {
    case LUA_TNUMBER:
      key.number = lua_isinteger(state, index) ? static_cast<long double>(lua_tointeger(state, index))
                                               : static_cast<long double>(lua_tonumber(state, index));
      return key;
    case LUA_TSTRING: {
      std::size_t size = 0;
      const char* s = lua_tolstring(state, index, &size);
      key.rank = 1;
      key.string = {s, size};
      return key;
    }
    case LUA_TBOOLEAN:
      key.rank = 2;
      key.number = lua_toboolean(state, index);
      return key;
    default: break;
  }
  const Ref* ref = to_ref(state, index);
  require(
      ref,
      "pairs: a key that is no number, no string, not true or false and no thing of the scene has no place in an order "
      "that is the same in every run");
  key.rank = 3 + static_cast<int>(ref->kind);
  key.serial = ref->serial;
  key.number = ref->serial == 0 ? static_cast<long double>(ref->slot) : 0;
  return key;
}

/// Upvalues: the table, its sorted keys, the place. Keys that went meanwhile are left out.
int next_pair(lua_State* state) {
  for (;;) {
    const lua_Integer i = lua_tointeger(state, lua_upvalueindex(3)) + 1;
    lua_pushinteger(state, i);
    lua_replace(state, lua_upvalueindex(3));
    if (lua_rawgeti(state, lua_upvalueindex(2), i) == LUA_TNIL) return 1;
    lua_pushvalue(state, -1);
    if (lua_rawget(state, lua_upvalueindex(1)) != LUA_TNIL) return 2;
    lua_pop(state, 2);
  }
}

int sorted_pairs(lua_State* state) {
  luaL_checkany(state, 1);
  unlock(state, 1);
  if (luaL_getmetafield(state, 1, "__pairs") != LUA_TNIL) {
    lua_pushvalue(state, 1);
    lua_call(state, 1, 3);
    return 3;
  }
  luaL_checktype(state, 1, LUA_TTABLE);
  lua_settop(state, 1);
  Interruptible loop;
  std::vector<Key> keys;
  lua_newtable(state);
  lua_pushnil(state);
  while (lua_next(state, 1)) {
    loop.count();
    lua_pop(state, 1);
    keys.push_back(key_at(state, 3));
    keys.back().index = static_cast<lua_Integer>(keys.size());
    lua_pushvalue(state, 3);
    lua_rawseti(state, 2, keys.back().index);
  }
  std::sort(keys.begin(), keys.end(), [&](const Key& a, const Key& b) {
    loop.count_bytes(std::min(a.string.size(), b.string.size()));
    return a < b;
  });
  lua_pushvalue(state, 1);
  lua_createtable(state, static_cast<int>(keys.size()), 0);
  for (std::size_t i = 0; i < keys.size(); i++) {
    loop.count();
    lua_rawgeti(state, 2, keys[i].index);
    lua_rawseti(state, -2, static_cast<lua_Integer>(i + 1));
  }
  lua_pushinteger(state, 0);
  lua_pushcclosure(state, guard<next_pair>, 3);
  lua_pushvalue(state, 1);
  lua_pushnil(state);
  return 3;
}

/// The smallest key above the given one: slow for a whole table, for which `pairs` is meant.
int sorted_next(lua_State* state) {
  luaL_checktype(state, 1, LUA_TTABLE);
  unlock(state, 1);
  lua_settop(state, 2);
  const bool first = lua_isnil(state, 2);
  const Key last = first ? Key{} : key_at(state, 2);
  Key best;
  bool found = false;
  Interruptible loop;
  lua_pushnil(state);  // 3: best key
  lua_pushnil(state);
  while (lua_next(state, 1)) {
    lua_pop(state, 1);
    const Key key = key_at(state, 4);
    loop.count_bytes(key.string.size());
    if ((!first && !(last < key)) || (found && !(key < best))) continue;
    best = key;
    found = true;
    lua_copy(state, 4, 3);
  }
  lua_settop(state, 3);
  if (!found) return 1;
  lua_pushvalue(state, 3);
  lua_rawget(state, 1);
  return 2;
}

}  // namespace

void open_pairs(lua_State* state) {
  push_lock(state);  // a state in a file names what the globals lead to
  lua_pushcclosure(state, guard<sorted_pairs>, 1);
  lua_setglobal(state, "pairs");
  lua_register(state, "next", guard<sorted_next>);
}

}  // namespace pantin::lua
