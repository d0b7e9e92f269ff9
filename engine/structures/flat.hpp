#pragma once
#include "structures/structure.hpp"

namespace pantin {

/// Moves the middle of its bounds to the origin.
void move_to_middle(Structure& s);
/// Adds the faces of a graph in the plane z = 0, without the one outside.
void add_flat_faces(Structure& s);

}  // namespace pantin
