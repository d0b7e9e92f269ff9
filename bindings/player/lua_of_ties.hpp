#pragma once
// Hinges, constraints and connections as the lines of Lua that make them.
#include <string>
#include <vector>

#include "player/lua_names.hpp"

namespace pantin::player {

struct LuaOfTie {
  std::vector<std::string> lines;  ///< none where there is nothing to be written
  std::string why_not;             ///< it cannot be written
};
/// `opened` is the scene as its script left it: what that joined is joined already.
LuaOfTie lua_of_hinge(const World& now, const World& opened, ParticleId ring, LuaNames& names);
LuaOfTie lua_of_constraint(const World& now, ConstraintId constraint, LuaNames& names);
LuaOfTie lua_of_connection(const World& now, ConnectionId connection, LuaNames& names);

}  // namespace pantin::player
