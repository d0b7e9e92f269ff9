#pragma once
#include <lua.hpp>

#include "lua/vm/runtime.hpp"

namespace pantin::lua {

/// Gives a state what a scene may use: `math string table utf8 coroutine` and the basic functions, made safe and the
/// same in every run: seeded `math.random`, sorted `pairs` and `next`, a stable `table.sort`, elementary functions with
/// the same bits everywhere, no addresses as text, no code but text, no finalizers, no loop that the clock cannot end.
extern const Opener sandbox;

/// Puts `function` into the table at the top as `name`; its upvalue 1 is the table's function `of`.
void replace_call(lua_State* state, const char* name, const char* of, lua_CFunction function);

// Its parts.
void open_math(lua_State* state);
void open_law_math(lua_State* state);
void open_pairs(lua_State* state);
void open_sort(lua_State* state);
void open_strings(lua_State* state);
void open_tables(lua_State* state);
void open_coroutines(lua_State* state);
void open_require(lua_State* state);
void open_read_table(lua_State* state);
void open_vectors(lua_State* state);

}  // namespace pantin::lua
