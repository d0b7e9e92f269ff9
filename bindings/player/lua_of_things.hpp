#pragma once
// Things of a world as the lines of Lua that make them, as a person would write them.
#include <string>
#include <vector>

#include "world/world.hpp"

namespace pantin::player {

struct LuaOfThings {
  std::string text;                   ///< lines; empty where nothing is to be written
  std::vector<std::string> left_out;  ///< what cannot be written, each by its name and why
};

/// What is in `now` and not in `opened`, which is the same scene as its script left it: things that went, things that were
/// moved, and things that were made since, in the order of their making. The lines are to stand after the script's.
LuaOfThings lua_of_things(const World& now, const World& opened);

}  // namespace pantin::player
