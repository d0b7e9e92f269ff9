#pragma once
// Between Lua and C++: every function that Lua may call is wrapped in `guard`, so that exceptions of ours become Lua
// errors with text and place. (Lua is compiled as C++: its own errors unwind our frames.)
#include <lua.hpp>
#include <string>

#include "base/check.hpp"
#include "scene/errors.hpp"

namespace pantin::lua {

/// Source of chunks that are part of the program; no place of a script is in them.
inline constexpr const char* own_chunk = "@pantin";

/// "scene.lua:12", the innermost line of a script that runs on this state; empty where none does.
std::string where(lua_State* state);

namespace detail {
int guarded(lua_State* state, lua_CFunction function);
}

template <lua_CFunction function>
int guard(lua_State* state) {
  return detail::guarded(state, function);
}

}  // namespace pantin::lua
