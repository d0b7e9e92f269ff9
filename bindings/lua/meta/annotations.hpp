#pragma once
#include <iosfwd>
#include <string>
#include <string_view>

namespace pantin::lua {

/// What a language server for Lua reads to know the scene's functions and fields, from the tables of the bindings:
/// scripts/meta/pantin.lua.
std::string annotations();
/// What is not made from the tables, and stands before and after what is: values and results; options of calls; free
/// functions.
extern const char* const annotations_head;
extern const char* const annotations_options;
extern const char* const annotations_shapes;
extern const char* const annotations_tail;
/// As a block of Lua within comments.
void write_example(std::ostream& out, std::string_view example);

}  // namespace pantin::lua
