#pragma once
// Convex polyhedra cut into parts. Lengths in m.
#include <memory>
#include <span>
#include <vector>

#include "shapes/hull.hpp"

namespace pantin {

/// A box as a hull, or the hull that it is; of what is round one whose corners are on its surface: 48 sides of a cylinder,
/// 24 meridians and 11 circles of a ball and of the ends of a capsule, the one about its middle twice. Null of what does not
/// move.
std::shared_ptr<const Hull> polyhedron_of(const Geometry& shape);
/// What of a hull lies where normal·x <= offset: all of it, or a part; null where that is nothing, or so thin that it is no
/// hull. The part on the other side has the same corners in the plane. `normal` has unit length.
std::shared_ptr<const Hull> behind(const std::shared_ptr<const Hull>& hull, Vec3 normal, double offset);
/// What of a hull is nearer to each of some positions than to all others (Voronoi 1908); null where nothing is.
std::vector<std::shared_ptr<const Hull>> voronoi_cells(const std::shared_ptr<const Hull>& hull,
                                                       std::span<const Vec3> sites);

}  // namespace pantin
