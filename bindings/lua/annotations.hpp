#pragma once
#include <string>

namespace pantin::lua {

/// What a language server for Lua reads to know the scene's functions and fields, from the tables of the bindings:
/// scripts/meta/pantin.lua.
std::string annotations();
/// What is not made from the tables, and stands before and after what is: values, options and results that are plain
/// tables; free functions.
extern const char* const annotations_head;
extern const char* const annotations_tail;

}  // namespace pantin::lua
