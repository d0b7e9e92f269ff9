#pragma once
// Structures as values of Lua: what `structure.cube{ … }` and the others return.
#include <lua.hpp>
#include <vector>

#include "lua/thing/fields.hpp"
#include "structures/structure.hpp"

namespace pantin::lua {

void push_structure(lua_State* state, Script& script, Structure structure);
/// Throws Error, beginning with `call`, where the value is no structure.
const Structure& check_structure(lua_State* state, int index, const char* call, const std::string& name);
/// Pushes what a function of a part is given: places [m] of a vertex, of both ends of an edge or of the middle of a face,
/// and its number. Returns how many values.
int push_part(lua_State* state, const Structure& s, Part part, std::uint32_t number);
MassIn check_mass_in(lua_State* state, int index, const std::string& what, const std::string& name);

/// A surface from a file below the scene's folder or in assets/meshes, times `scale` > 0. Holes are told in the log.
Structure mesh_of_file(lua_State* state, Script& script, const std::string& name, double scale);

/// The functions of the table `structure`; upvalue 1 of each: the script.
const std::vector<Method>& structure_makers();
/// Puts the table `structure` into the globals.
void open_structures(lua_State* state, Script& script);

}  // namespace pantin::lua
