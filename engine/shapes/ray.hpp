#pragma once
#include <optional>

#include "shapes/shape.hpp"

namespace pantin {

struct RayHit {
  double part;  ///< of the way, 0 … 1
  Vec3 normal;  ///< outwards, of unit length, world; of a ray that begins inside against its direction
};

/// Where the way from `from` to `to` [m] first meets a shape; at once where it begins inside. Any shape; a mesh has no inside
/// and is met from both sides, its normal towards where the ray comes from.
std::optional<RayHit> ray(const Geometry& shape, const Pose& pose, Vec3 from, Vec3 to);
/// The first touch of a convex shape that is moved by `way` [m] without turning, with any other shape; part 0 and the
/// normal of the overlap where they overlap at the start. Triangles are met from both sides, or at their fronts alone.
std::optional<RayHit> cast(const Geometry& moved, const Pose& pose, Vec3 way, const Geometry& other,
                           const Pose& at_other, bool fronts_alone = false);
bool inside(const Geometry& shape, const Pose& pose, Vec3 point);
/// Of a convex shape with any other.
bool overlaps(const Geometry& convex, const Pose& pose, const Geometry& other, const Pose& at_other);

}  // namespace pantin
