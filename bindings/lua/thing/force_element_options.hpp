#pragma once
// scene:connect, interact and field.
#include <lua.hpp>

#include <vector>

#include "edit/edit.hpp"
#include "lua/law/law_run.hpp"
#include "lua/thing/fields.hpp"

namespace pantin::lua {

/// `{ families, near, below, above, law }`, or `hinge` in place of a law
int scene_bonding(lua_State* state);
int scene_connect(lua_State* state);
int scene_interact(lua_State* state);
int scene_field(lua_State* state);

/// Ties ends by the law at `index` of the stack, with the options after it.
ConnectionId connect(const Self& self, std::vector<End> ends, int index);
/// What a law may read of a particle of a family.
KnownNames names_of_family(const World& world, FamilyId family);

}  // namespace pantin::lua
