#include "lua/value/copies.hpp"

#include <string_view>
#include <utility>

#include "lua/value/tostring.hpp"
#include "lua/vm/guard.hpp"
#include "lua/vm/runtime.hpp"

namespace pantin::lua {
namespace {

const char lock_key = 0;  // of the registry

/// Pushes what a locked table holds at a key that no other table of values has: its contents at false, the message at true.
/// In a state that was forged either may be missing.
void push_held(lua_State* state, int index, bool which) {
  index = lua_absindex(state, index);
  lua_pushboolean(state, which);
  lua_rawget(state, index);
}

void push_contents(lua_State* state, int index) {
  require(lua_istable(state, index), "a copy is a table");
  push_held(state, index, false);
  require(lua_istable(state, -1), "a copy has no contents");
}

/// What had another name once answers to it, and says so. The key is at 2, the contents are at -2.
void push_by_old_name(lua_State* state) {
  constexpr std::pair<std::string_view, const char*> names[] = {{"safe_step", "fallback_step"},
                                                                {"safe_steps", "fallback_steps"}};
  for (const auto& [old, now] : names) {
    if (lua_tostring(state, 2) != old || lua_getfield(state, -2, now) == LUA_TNIL) continue;
    if (const auto& notice = Runtime::of(state).notice) notice(text("'", old, "' is called '", now, "' now"));
    return;
  }
}

int locked_contents(lua_State* state) {
  push_contents(state, 1);
  return 1;
}

int locked_index(lua_State* state) {
  push_contents(state, 1);
  lua_pushvalue(state, 2);
  if (lua_rawget(state, -2) == LUA_TNIL && lua_type(state, 2) == LUA_TSTRING) push_by_old_name(state);
  return 1;
}

int locked_length(lua_State* state) {
  push_contents(state, 1);
  lua_pushinteger(state, static_cast<lua_Integer>(lua_rawlen(state, -1)));
  return 1;
}

int locked_change(lua_State* state) {
  require(lua_istable(state, 1), "a copy is a table");
  std::string message = message_of_locked(state, 1);
  if (message.ends_with(" = ")) {
    const bool plain = lua_type(state, 2) == LUA_TSTRING && lua_type(state, 3) == LUA_TNUMBER;
    if (plain) {
      const std::string key(push_text(state, 2)), value(push_text(state, 3));
      message += text("{ ", key, " = ", value, " }");
    } else {
      message += "{ … }";
    }
  }
  throw Error(message);
}

}  // namespace

void push_lock(lua_State* state) {
  if (lua_rawgetp(state, LUA_REGISTRYINDEX, &lock_key) != LUA_TNIL) return;
  lua_pop(state, 1);
  lua_newtable(state);
  const luaL_Reg functions[] = {{"__index", guard<locked_index>},
                                {"__newindex", guard<locked_change>},
                                {"__len", guard<locked_length>},
                                {contents_field, guard<locked_contents>},
                                {nullptr, nullptr}};
  luaL_setfuncs(state, functions, 0);
  lua_pushliteral(state, "copy");
  lua_setfield(state, -2, "__metatable");
  lua_pushvalue(state, -1);
  lua_rawsetp(state, LUA_REGISTRYINDEX, &lock_key);
}

void lock(lua_State* state, const std::string& message) {
  lua_createtable(state, 0, 2);
  lua_insert(state, -2);
  lua_pushboolean(state, 0);
  lua_insert(state, -2);
  lua_rawset(state, -3);
  lua_pushboolean(state, 1);
  lua_pushlstring(state, message.data(), message.size());
  lua_rawset(state, -3);
  push_lock(state);
  lua_setmetatable(state, -2);
}

bool is_locked(lua_State* state, int index) {
  if (!lua_istable(state, index) || !lua_getmetatable(state, index)) return false;
  push_lock(state);
  const bool same = lua_rawequal(state, -1, -2);
  lua_pop(state, 2);
  return same;
}

std::string message_of_locked(lua_State* state, int index) {
  push_held(state, index, true);
  std::string message = lua_type(state, -1) == LUA_TSTRING ? lua_tostring(state, -1) : "a copy cannot be written";
  lua_pop(state, 1);
  return message;
}

void unlock(lua_State* state, int index) {
  if (!lua_istable(state, index)) return;
  index = lua_absindex(state, index);
  if (luaL_getmetafield(state, index, contents_field) == LUA_TNIL) return;
  if (!lua_iscfunction(state, -1)) return lua_pop(state, 1);
  lua_pushvalue(state, index);
  lua_call(state, 1, 1);
  lua_replace(state, index);
}

}  // namespace pantin::lua
