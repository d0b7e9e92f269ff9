#pragma once
// What is met by a ray or a shape on its way, and what is where. Shapes are where they are now: before the first step, after a
// step, and after edits. Of some n shapes about log n are looked at, but all of them at the first question after an edit.
#include <vector>

#include "world/world.hpp"

namespace pantin {

struct Hit {
  ShapeId shape;
  Vec3 at = zero3();      ///< [m]
  Vec3 normal = zero3();  ///< out of the shape, of unit length; 0 where there is none
  double distance = 0.0;  ///< [m] along the way; below 0: as deep as they overlap
};

/// Which shapes count.
struct HitFilter {
  std::vector<std::uint32_t> layers = {};  ///< rising; those in one of them
  bool any_layer = true;                   ///< those in none of these, too
  std::vector<AnyId> ignored = {};         ///< but for shapes, and those of bodies, in here
  bool sensors = false;                    ///< those too that are sensors
};

/// Nearest first, of equals the older: where a ray first meets each shape between two positions [m]. One that begins in a shape
/// meets it at once, with a normal against its direction.
std::vector<Hit> hits_of_ray(World& world, Vec3 from, Vec3 to, const HitFilter& filter = {});
/// The same without an end; the direction may have any length but 0.
std::vector<Hit> hits_of_endless_ray(World& world, Vec3 from, Vec3 direction, const HitFilter& filter = {});
/// Where a convex shape that moves along `way` [m] without turning first touches each other.
std::vector<Hit> hits_of_cast(World& world, const Geometry& convex, const Pose& pose, Vec3 way,
                              const HitFilter& filter = {});
/// What overlaps a convex shape, deepest first; `at` is on the convex shape where it is deepest.
std::vector<Hit> overlapping(World& world, const Geometry& convex, const Pose& pose, const HitFilter& filter = {});
/// What a position [m] is inside of, the older first. A mesh has no inside.
std::vector<Hit> containing(World& world, Vec3 at, const HitFilter& filter = {});

}  // namespace pantin
