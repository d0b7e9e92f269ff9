#pragma once
// Tables that are copies of what a thing has: a script that writes into one would change nothing, and is told so.
#include <lua.hpp>
#include <string>

namespace pantin::lua {

/// The field of a metatable with a C function that makes a plain table of what its table shows.
inline constexpr const char* contents_field = "__contents";

/// Pushes the metatable of locked tables.
void push_lock(lua_State* state);
/// The plain table at the top becomes one that can be read, handed over and gone through, but not written: that is an error
/// with `message`, after which comes what to write where it ends with " = ".
void lock(lua_State* state, const std::string& message);
bool is_locked(lua_State* state, int index);
/// What `lock` was told of a locked table.
std::string message_of_locked(lua_State* state, int index);
/// Where the value at `index` is a table that shows more than it holds, puts a plain one with that in its place.
void unlock(lua_State* state, int index);

}  // namespace pantin::lua
