#pragma once
// Bodies and their points as tables of Lua.
#include <lua.hpp>
#include <string>

#include "edit/edit.hpp"

namespace pantin::lua {

struct Script;

/// A point: a vec in the body's frame, or { at, mass, color, radius }, and `name` where `may_name`.
PointDef point_def(lua_State* state, int index, const std::string& call, const std::string& name, bool may_name);
/// `{ shape, shapes, points, at, orientation, velocity, spin, mass, inertia, color, picture, sprite, name }`.
BodyDef body_def(Script& script, lua_State* state, int index);
/// A body of one shape, whose sizes and material are among its options: a "ball", "box", "capsule" or "cylinder".
BodyDef solid_def(Script& script, lua_State* state, int index, const char* kind, const char* call);
/// The vec of the diagonal, or { xx, yy, zz, xy, xz, yz } by name or in this order, [kg m²].
Mat3 check_inertia(lua_State* state, int index, const std::string& what);
void push_inertia(lua_State* state, const Mat3& inertia);

}  // namespace pantin::lua
