#pragma once
// `parameters` of a connection, an interaction or a field: a table that reads and writes those of the law at work in it.
#include "lua/value/ref.hpp"

namespace pantin::lua {

void push_law_parameters(lua_State* state, const Ref& thing);
/// Pushes the metatable of all such tables.
void push_law_parameters_type(lua_State* state);
/// Whose parameters the table at `index` has; null where it is no such table.
const Ref* thing_of_parameters(lua_State* state, int index);

}  // namespace pantin::lua
