#pragma once
// scene:connect, interact and field.
#include <lua.hpp>

#include "lua/law_run.hpp"
#include "world/world.hpp"

namespace pantin::lua {

/// `{ families, near, below, above, law }`
int scene_bonding(lua_State* state);
int scene_connect(lua_State* state);
int scene_interact(lua_State* state);
int scene_field(lua_State* state);

/// What a law may read of a particle of a family.
KnownNames names_of_family(const World& world, FamilyId family);

}  // namespace pantin::lua
