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

/// `resume` and `close`: upvalue 1 is Lua's own.
int on_coroutine(lua_State* state) {
  luaL_checktype(state, 1, LUA_TTHREAD);
  lua_State* coroutine = lua_tothread(state, 1);
  lua_pushvalue(state, lua_upvalueindex(1));
  lua_insert(state, 1);
  return call_switched(state, coroutine);
}

/// What `wrap` returns: upvalue 1 is what Lua's own returned, 2 its coroutine.
int call_wrapped(lua_State* state) {
  lua_State* coroutine = lua_tothread(state, lua_upvalueindex(2));
  lua_pushvalue(state, lua_upvalueindex(1));
  lua_insert(state, 1);
  return call_switched(state, coroutine);
}

int wrap(lua_State* state) {
  lua_settop(state, 1);
  lua_pushvalue(state, lua_upvalueindex(1));
  lua_insert(state, 1);
  lua_call(state, 1, 1);
  lua_getupvalue(state, 1, 1);
  lua_pushcclosure(state, guard<call_wrapped>, 2);
  return 1;
}

void replace_call(lua_State* state, const char* name, lua_CFunction function) {
  lua_getfield(state, -1, name);
  lua_pushcclosure(state, function, 1);
  lua_setfield(state, -2, name);
}

}  // namespace

void open_coroutines(lua_State* state) {
  lua_getglobal(state, "coroutine");
  replace_call(state, "resume", guard<on_coroutine>);
  replace_call(state, "close", guard<on_coroutine>);
  replace_call(state, "wrap", guard<wrap>);
  lua_pop(state, 1);
}

}  // namespace pantin::lua
