#pragma once
#include <lua.hpp>
#include <set>

namespace pantin::lua {

/// While it lives, plain tables that functions see from outside refuse what is traced as a key: Lua would find nothing there, and
/// tell nobody.
class KeyGuards {
 public:
  explicit KeyGuards(lua_State* state);
  /// Tables are as they were.
  ~KeyGuards();
  KeyGuards(const KeyGuards&) = delete;
  KeyGuards& operator=(const KeyGuards&) = delete;

  /// Of the function at the top of `state`; a thousand tables of all functions at most.
  void guard_seen_by_function(lua_State* state);

 private:
  void guard(lua_State* state);

  lua_State* state_;
  int guarded_, metatable_;  ///< references to a list of tables, and to what they have got
  lua_Integer count_ = 0;    ///< of that list
  std::set<const void*> known_;
};

}  // namespace pantin::lua
