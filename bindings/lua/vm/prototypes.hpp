#pragma once
// The functions of a text, each as what Lua loads it from: so that a function made by a script can be named by where it is in
// the text, and made anew.
#include <lua.hpp>
#include <string>
#include <vector>

namespace pantin::lua {

/// A text that a script runs, and what messages call it.
struct SourceText {
  std::string name, source;
};

/// What `lua_dump` gives for the function at the top of the stack.
std::string dumped(lua_State* state);
/// The same of the whole text and of all functions in it, each after that which it is in.
std::vector<std::string> prototypes(lua_State* state, const SourceText& chunk);

}  // namespace pantin::lua
