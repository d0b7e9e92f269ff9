#pragma once
#include <lua.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace pantin::lua {

/// What of a function is silently wrong of a symbol.
struct Silent {
  /// "scene.lua:12: …" where it, or one written inside of it, tests two values or a value and a number for equality, or where
  /// that cannot be told; else empty. Such a test is false of a symbol and a number, and Lua tells nobody.
  std::string equality;
  bool indexes = true;  ///< whether it may read a table at a value
};
/// Of the function at `index`.
Silent silent_of(lua_State* state, int index);
/// The line of the first such test in a function as lua_dump writes it, or 0; nothing where it is not written as known
/// releases of Lua (LUA_VERSION_RELEASE_NUM) do.
std::optional<int> line_of_equality(std::string_view function, int release, bool* indexes = nullptr);

}  // namespace pantin::lua
