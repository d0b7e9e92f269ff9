#pragma once
#include "shapes/simplex.hpp"
#include "shapes/widest.hpp"

namespace pantin {

/// Takes a direction found to about 1e-6 to round-off, where one of two cores is a cylinder: Newton's method on the sphere,
/// free and square to the edges that are active, and the directions that edges, faces and axes give. `simplex` holds
/// points of the features that are nearest.
Widest polished(const CorePair& pair, Vec3 normal, const Simplex& simplex);

}  // namespace pantin
