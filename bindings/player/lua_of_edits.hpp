#pragma once
// What happened to the things of a script, as the lines of Lua that do it.
#include <string>
#include <vector>

#include "player/lua_names.hpp"

namespace pantin::player {

struct LuaOfEdits {
  std::vector<std::string> lines;
  std::vector<std::string> left_out;  ///< what cannot be written, and why
};
/// Things of `opened` that are gone in `now`, are elsewhere, or move in another way.
LuaOfEdits lua_of_edits(const World& now, const World& opened, LuaNames& names);

}  // namespace pantin::player
