#pragma once
// What tables held: `scene.store` and the `data` of things, as a snapshot keeps them.
#include <lua.hpp>
#include <string>

#include "lua/value/callback.hpp"

namespace pantin::lua {

/// The contents of tables, and of the tables in them. The tables stay the same Lua values when these are put back, so
/// that what a script holds of them goes on to be theirs.
class KeptTables {
 public:
  explicit KeptTables(lua_State* state);
  ~KeptTables();
  KeptTables(const KeptTables&) = delete;
  KeptTables& operator=(const KeptTables&) = delete;

  /// Keeps the table at `index`, called `name` in messages, where it must hold plain values only: numbers, strings, true
  /// and false, vecs, quats, things of the scene, and tables of these without a metatable. Throws Error otherwise.
  void keep_plain(lua_State* state, int index, const std::string& name);
  /// The same, but what is not plain is kept as the value that it is.
  void keep(lua_State* state, int index);
  /// Puts the contents of all tables back.
  void put_back(lua_State* state) const;

 private:
  Runtime& runtime_;
  int reference_;
};

}  // namespace pantin::lua
