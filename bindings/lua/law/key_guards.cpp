#include "lua/law/key_guards.hpp"

#include "lua/law/symbol.hpp"
#include "lua/law/trace.hpp"
#include "lua/vm/guard.hpp"

namespace pantin::lua {
namespace {

constexpr std::size_t most_tables = 1000;
constexpr int room = 8;  // of the stack, for each table in a table

int refuse_traced_key(lua_State* state) {
  if (const auto tag = tag_of(state, 2); tag == Tag::symbol || tag == Tag::symbol_vec)
    SymbolAlgebra(state).trace.refuse(state, "a table is read at a value that differs from pair to pair");
  lua_pushnil(state);
  return 1;
}

}  // namespace

KeyGuards::KeyGuards(lua_State* state) : state_(state) {
  lua_newtable(state);
  guarded_ = luaL_ref(state, LUA_REGISTRYINDEX);
  lua_newtable(state);
  lua_pushcfunction(state, lua::guard<refuse_traced_key>);
  lua_setfield(state, -2, "__index");
  metatable_ = luaL_ref(state, LUA_REGISTRYINDEX);
}

KeyGuards::~KeyGuards() {
  lua_rawgeti(state_, LUA_REGISTRYINDEX, metatable_);
  lua_rawgeti(state_, LUA_REGISTRYINDEX, guarded_);
  for (lua_Integer i = 1; i <= count_; i++) {
    lua_rawgeti(state_, -1, i);
    if (lua_getmetatable(state_, -1) != 0) {
      const bool is_ours = lua_rawequal(state_, -1, -4) != 0;
      lua_pop(state_, 1);
      if (is_ours) {
        lua_pushnil(state_);
        lua_setmetatable(state_, -2);
      }
    }
    lua_pop(state_, 1);
  }
  lua_pop(state_, 2);
  luaL_unref(state_, LUA_REGISTRYINDEX, guarded_);
  luaL_unref(state_, LUA_REGISTRYINDEX, metatable_);
}

void KeyGuards::guard_seen_by_function(lua_State* state) {
  if (!known_.insert(lua_topointer(state, -1)).second || !lua_checkstack(state, room)) return;
  for (int i = 1; lua_getupvalue(state, -1, i) != nullptr; i++) {
    guard(state);
    lua_pop(state, 1);
  }
}

/// The table at the top, and those in it.
void KeyGuards::guard(lua_State* state) {
  if (!lua_istable(state, -1) || known_.size() >= most_tables || !lua_checkstack(state, room) ||
      !known_.insert(lua_topointer(state, -1)).second)
    return;
  lua_pushnil(state);
  while (lua_next(state, -2) != 0) {
    guard(state);
    lua_pop(state, 1);
  }
  if (lua_getmetatable(state, -1) != 0) return lua_pop(state, 1);
  lua_rawgeti(state, LUA_REGISTRYINDEX, guarded_);
  lua_pushvalue(state, -2);
  lua_rawseti(state, -2, ++count_);
  lua_pop(state, 1);
  lua_rawgeti(state, LUA_REGISTRYINDEX, metatable_);
  lua_setmetatable(state, -2);
}

}  // namespace pantin::lua
