#pragma once
// Surfaces from files.
#include <string>

#include "structures/structure.hpp"

namespace pantin {

/// Vertices and faces of a Wavefront .obj [m]; `name` begins messages. What else is in it (normals, textures, lines) is left
/// out, vertices of no face too. Throws Error where there are no faces, or one is of vertices that are not there.
Structure read_mesh_file(const std::string& text, const std::string& name);

/// How many edges are not between two faces that go round them in opposite senses: 0 of a surface without holes.
std::size_t open_edges(const Structure& s);

}  // namespace pantin
