// Coroutines that the limit of time reaches: hooks belong to one coroutine, so the watch is told which one runs.
#include "lua/library/sandbox.hpp"
#include "lua/vm/runtime.hpp"

namespace pantin::lua {
namespace {

/// Calls Lua's own function (below the arguments) with the watch on `coroutine`.
int call_switched(lua_State* state, lua_State* coroutine) {
  const Switched switched(Runtime::of(state).watch(), coroutine);
  lua_call(state, lua_gettop(state) - 1, LUA_MULTRET);
  return lua_gettop(state);
}

/// Whether its time was up when it ended. Lua calls no hook in it from then on, so that nothing would stop what its
/// variables have as `__close`.
bool was_stopped(lua_State* coroutine) {
  return lua_status(coroutine) > LUA_YIELD && lua_gethook(coroutine) != nullptr;
}

/// Upvalue 1 is Lua's own.
int resume(lua_State* state) {
  luaL_checktype(state, 1, LUA_TTHREAD);
  lua_State* coroutine = lua_tothread(state, 1);
  lua_pushvalue(state, lua_upvalueindex(1));
  lua_insert(state, 1);
  return call_switched(state, coroutine);
}

/// Upvalue 1 is Lua's own.
int close(lua_State* state) {
  luaL_checktype(state, 1, LUA_TTHREAD);
  require(!was_stopped(lua_tothread(state, 1)), "close: the coroutine was stopped");
  return resume(state);
}

/// What `wrap` returns: upvalue 1 is Lua's own `resume`, 2 the coroutine.
int call_wrapped(lua_State* state) {
  lua_State* coroutine = lua_tothread(state, lua_upvalueindex(2));
  lua_pushvalue(state, lua_upvalueindex(1));
  lua_insert(state, 1);
  lua_pushvalue(state, lua_upvalueindex(2));
  lua_insert(state, 2);
  const int count = call_switched(state, coroutine);
  if (lua_toboolean(state, 1)) return count - 1;
  if (lua_status(coroutine) > LUA_YIELD && !was_stopped(coroutine)) {
    const Switched switched(Runtime::of(state).watch(), coroutine);
    lua_resetthread(coroutine);  // closes its variables
    lua_xmove(coroutine, state, 1);
  }
  return lua_error(state);
}

/// Upvalue 1 is Lua's own `resume`.
int wrap(lua_State* state) {
  luaL_checktype(state, 1, LUA_TFUNCTION);
  lua_pushvalue(state, lua_upvalueindex(1));
  lua_State* coroutine = lua_newthread(state);
  lua_pushvalue(state, 1);
  lua_xmove(state, coroutine, 1);
  lua_pushcclosure(state, guard<call_wrapped>, 2);
  return 1;
}

}  // namespace

void open_coroutines(lua_State* state) {
  lua_getglobal(state, "coroutine");
  replace_call(state, "wrap", "resume", guard<wrap>);
  replace_call(state, "close", "close", guard<close>);
  replace_call(state, "resume", "resume", guard<resume>);
  lua_pop(state, 1);
}

}  // namespace pantin::lua
