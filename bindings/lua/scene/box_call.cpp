#include "lua/scene/box_call.hpp"

#include "lua/value/ref.hpp"
#include "lua/value/values.hpp"
#include "lua/vm/guard.hpp"

namespace pantin::lua {
namespace {

/// (value, arguments …): called where a value that is no function is called. Upvalue 1: what makes a box.
int call_value(lua_State* state) {
  lua_Debug called;
  const bool known = lua_getstack(state, 0, &called) != 0 && lua_getinfo(state, "n", &called) != 0 && called.name;
  const std::string name = known ? text(called.namewhat, " '", called.name, "'") : "";
  const Ref* self = lua_gettop(state) >= 2 ? to_ref(state, 2) : nullptr;
  require(name == "method 'box'" && self && self->kind == Kind::scene, "attempt to call a ",
          lua_isnil(state, 1) ? "nil" : "vec", " value", known ? text(" (", name, ")") : name);
  lua_pushvalue(state, lua_upvalueindex(1));
  lua_replace(state, 1);
  lua_call(state, lua_gettop(state) - 1, 1);
  return 1;
}

}  // namespace

void let_box_be_called(lua_State* state, lua_CFunction make_box) {
  push(state, zero3());
  lua_getmetatable(state, -1);
  lua_pushnil(state);
  lua_newtable(state);
  for (const int metatable : {-3, -1}) {
    lua_pushcfunction(state, make_box);
    lua_pushcclosure(state, guard<call_value>, 1);
    lua_setfield(state, metatable - 1, "__call");
  }
  lua_setmetatable(state, -2);
  lua_pop(state, 3);
}

}  // namespace pantin::lua
