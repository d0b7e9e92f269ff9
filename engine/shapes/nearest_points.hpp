#pragma once
#include "shapes/distance.hpp"
#include "shapes/simplex.hpp"
#include "shapes/widest.hpp"

namespace pantin {

/// Nearest points of two cores whose normal and gap are known to round-off: of the features that face each other along the
/// normal. `simplex`, found with b moved by `moved` [m], says where on features that are parallel.
Separation nearest_points(const CorePair& pair, const Widest& widest, const Simplex& simplex, Vec3 moved);

/// Nearest points of two segments that are not parallel, on their lines; of parallel ones the middle of what they share.
Separation of_segments(const CorePair& pair);

}  // namespace pantin
