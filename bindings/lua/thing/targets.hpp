#pragma once
// Things as arguments: where a particle is wanted, a point stands for its particle, and where a point is wanted, a
// particle stands for its point.
#include <lua.hpp>
#include <string>

#include "lua/thing/handles.hpp"

namespace pantin::lua {

/// What a rope may run over or end at.
Passage check_point_or_position(lua_State* state, int index, const std::string& call, const std::string& name);
/// Any living thing of the script's world.
const Ref& check_thing(lua_State* state, int index, const std::string& call, const std::string& name);
const Ref& check_kind(lua_State* state, int index, Kind kind, const std::string& call, const std::string& name);
/// The point that a point or a particle stands for; of a hinge the one at which it is pulled.
PointId check_point(lua_State* state, int index, const std::string& call, const std::string& name);
BodyId check_body(lua_State* state, int index, const std::string& call, const std::string& name);
/// "argument 2"
std::string argument(int number);

}  // namespace pantin::lua
