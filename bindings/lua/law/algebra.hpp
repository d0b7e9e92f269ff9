#pragma once
// What numbers and vecs of laws do under Lua's operators, `math` and vec's methods: the same for symbols, while a law is
// traced, and for numbers with derivatives, while it is called.
#include <lua.hpp>

#include "lua/value/values.hpp"

namespace pantin::lua {

/// Operations of vecs that a plain vec hands on where the other operand is of a law.
enum class VecOperation { add, subtract, multiply, divide, dot, cross, make };

/// Whether one of the first `count` arguments is a number or vec of a law.
bool has_law_value(lua_State* state, int count);
/// Whether one of them is being traced.
bool is_traced(lua_State* state, int count);
/// Does it for arguments of which one is of a law; returns the number of results.
int law_vec(lua_State* state, VecOperation operation);

/// Gives the userdata at the top its metatable.
void set_algebra_metatable(lua_State* state, Tag tag);

}  // namespace pantin::lua
