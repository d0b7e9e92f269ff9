#include "lua/library/sandbox.hpp"

#include "lua/law/force.hpp"
#include "lua/law/law_run.hpp"
#include "lua/value/error_text.hpp"
#include "lua/value/tostring.hpp"
#include "lua/vm/runtime.hpp"

namespace pantin::lua {
namespace {

/// Refused are `__gc`, since no limit of time reaches a finalizer, and `__mode`, since what a weak table has lost depends on
/// the memory of the run.
int set_metatable(lua_State* state) {
  for (const char* name : {"__gc", "__mode"}) {
    if (!lua_istable(state, 2)) break;
    lua_pushstring(state, name);
    lua_rawget(state, 2);
    require(lua_isnil(state, -1), "setmetatable: ", name, " is not allowed in scenes");
    lua_pop(state, 1);
  }
  return lua_tocfunction(state, lua_upvalueindex(1))(state);
}

/// Lua runs the message handler of its own xpcall inside of the hook that stops a script, where no hook reaches it.
const char* const own_xpcall = R"(
  local pcall, select = pcall, select
  local function handle(handler, ok, ...)
    if ok then return true, ... end
    return false, select(2, pcall(handler, ...))
  end
  function xpcall(f, handler, ...) return handle(handler, pcall(f, ...)) end
)";

void forget(lua_State* state, const char* name) {
  lua_pushnil(state);
  lua_setfield(state, -2, name);
}

void open(lua_State* state) {
  const luaL_Reg libraries[] = {{LUA_GNAME, luaopen_base},        {LUA_TABLIBNAME, luaopen_table},
                                {LUA_STRLIBNAME, luaopen_string}, {LUA_MATHLIBNAME, luaopen_math},
                                {LUA_UTF8LIBNAME, luaopen_utf8},  {LUA_COLIBNAME, luaopen_coroutine}};
  for (const luaL_Reg& library : libraries) {
    luaL_requiref(state, library.name, library.func, 1);
    lua_pop(state, 1);
  }
  lua_pushglobaltable(state);
  for (const char* name : {"dofile", "loadfile", "load", "collectgarbage"}) forget(state, name);
  replace_call(state, "setmetatable", "setmetatable", guard<set_metatable>);
  lua_pop(state, 1);
  Runtime::of(state).load(state, own_xpcall, own_chunk + 1);
  lua_call(state, 0, 0);
  open_math(state);
  open_law_math(state);
  open_pairs(state);
  open_sort(state);
  open_strings(state);
  open_tables(state);
  open_tostring(state);
  open_coroutines(state);
  open_require(state);
  open_read_table(state);
  open_vectors(state);
  open_law_run(state);
  open_force(state);
}

}  // namespace

void replace_call(lua_State* state, const char* name, const char* of, lua_CFunction function) {
  lua_getfield(state, -1, of);
  lua_pushcclosure(state, function, 1);
  lua_setfield(state, -2, name);
}

const Opener sandbox = {open, describe_error};

}  // namespace pantin::lua
