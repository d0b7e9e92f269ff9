#pragma once
// Layers that a script speaks of: those that nothing has may be misspelt.
#include <string>
#include <string_view>

#include "lua/thing/script.hpp"

namespace pantin::lua {

/// Notes that a script speaks of a layer in a call that gives it to nothing.
void speak_of_layer(Script& script, lua_State* state, std::string_view call, const std::string& layer);
/// After a step: warns of those since the last step that nothing has, where another is spelt nearly so. What is made later may
/// have the rest.
void tell_unknown_layers(Script& script);

}  // namespace pantin::lua
