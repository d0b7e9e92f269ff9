#pragma once
#include <string>

namespace pantin::lua {

/// What a language server for Lua reads to know the scene's functions and fields, from the tables of the bindings:
/// scripts/meta/pantin.lua.
std::string annotations();

}  // namespace pantin::lua
