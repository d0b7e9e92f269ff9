// `scene:behave`: a table of functions start, step and stop, put to work on a target.
#include "lua/scene/events.hpp"
#include "lua/thing/fields.hpp"
#include "lua/thing/script.hpp"
#include "lua/thing/targets.hpp"
#include "lua/value/arguments.hpp"
#include "lua/vm/guard.hpp"

namespace pantin::lua {
namespace {

/// Upvalues: the behaviour at work, and the name of the function.
int call_part(lua_State* state) {
  lua_pushvalue(state, lua_upvalueindex(2));
  lua_gettable(state, lua_upvalueindex(1));
  if (lua_isnil(state, -1)) return 0;
  lua_pushvalue(state, lua_upvalueindex(1));
  lua_rotate(state, 1, 2);
  lua_call(state, lua_gettop(state) - 1, 0);
  return 0;
}

/// Of the behaviour at work at the top.
Callback part(lua_State* state, const char* name) {
  lua_pushvalue(state, -1);
  lua_pushstring(state, name);
  lua_pushcclosure(state, call_part, 2);
  const Callback callback(state, lua_gettop(state));
  lua_pop(state, 1);
  return callback;
}

void check_behaviour(lua_State* state, int index) {
  require(lua_istable(state, index), "behave: argument 2, the behaviour, must be a table { start, step, stop }, got ",
          kind_of_value(state, index));
  bool any = false;
  for (const char* name : {"start", "step", "stop"}) {
    const int type = lua_getfield(state, index, name);
    require(type == LUA_TNIL || type == LUA_TFUNCTION, "behave: ", name, " must be a function self, …, got ",
            kind_of_value(state, -1));
    any = any || type == LUA_TFUNCTION;
    lua_pop(state, 1);
  }
  require(any, "behave: the behaviour has no start, step or stop");
}

/// Pushes a table of this one's own, which looks up in the behaviour what it does not have.
void push_at_work(lua_State* state) {
  lua_newtable(state);
  lua_pushvalue(state, 2);
  lua_setfield(state, -2, "target");
  if (lua_istable(state, 4))
    lua_pushvalue(state, 4);
  else
    lua_newtable(state);
  lua_setfield(state, -2, "options");
  lua_newtable(state);
  lua_pushvalue(state, 3);
  lua_setfield(state, -2, "__index");
  lua_setmetatable(state, -2);
}

}  // namespace

lua_CFunction behaviour_part() { return call_part; }

int scene_behave(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "behave");
  lua_settop(state, 4);
  const Ref* ref = to_ref(state, 2);
  AnyId target;
  if (!ref || ref->kind != Kind::scene) target = check_thing(state, 2, "behave", "argument 1, the target,").thing;
  check_behaviour(state, 3);
  require(lua_isnoneornil(state, 4) || lua_istable(state, 4), "behave: argument 3, the options, must be a table, got ",
          kind_of_value(state, 4));
  push_at_work(state);
  part(state, "start").call();
  return subscribe(state, self.script, {0, "step", part(state, "step"), target, part(state, "stop")});
}

}  // namespace pantin::lua
