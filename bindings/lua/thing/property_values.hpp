#pragma once
// The values of properties, as Lua has them.
#include "lua/thing/fields.hpp"

namespace pantin::lua {

void push_value(lua_State* state, Script& script, const fields::Value& value);
/// What is to be written to a property. Throws Error that names the property, what it must be, and what came.
fields::Value check_value(const Self& self, const fields::Property& property, int index);

}  // namespace pantin::lua
