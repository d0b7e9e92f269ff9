#pragma once
// Straight ways through triangles: what rays and casts have in common. In axes of the mesh or the height field.
#include <functional>
#include <optional>

#include "shapes/mesh.hpp"
#include "shapes/ray.hpp"

namespace pantin {

struct Way {
  Vec3 from, along;     ///< [m]
  Vec3 half = zero3();  ///< [m] of a box about what moves
};

/// Whether a way meets bounds before a part of it.
bool meets(const Way& way, const Bounds& bounds, double before);

/// Where what moves first meets one triangle.
using MeetTriangle = std::function<std::optional<RayHit>(const MeshTriangle&)>;
/// The first of all triangles near the way; of several at the same part that of the lowest index.
std::optional<RayHit> first_met(const TriangleMesh& mesh, const Way& way, const MeetTriangle& meet);
std::optional<RayHit> first_met(const HeightField& field, const Way& way, const MeetTriangle& meet);

/// The triangle above a point that is below the surface or on it, within the grid.
std::optional<MeshTriangle> triangle_above(const HeightField& field, Vec3 point);

}  // namespace pantin
