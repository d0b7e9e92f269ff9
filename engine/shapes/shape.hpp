#pragma once
// Shapes that touch, as geometry alone: each in axes of its own, put somewhere by a pose. Lengths in m.
#include <cstdint>
#include <memory>
#include <variant>
#include <vector>

#include "base/bounds.hpp"
#include "base/lanes.hpp"

namespace pantin {

struct Hull;
struct TriangleMesh;
struct HeightField;

struct BallShape {
  double radius;
};
/// Edges along the axes.
struct BoxShape {
  Vec3 half;
};
/// All within `radius` of the line from (0, 0, -half) to (0, 0, half).
struct CapsuleShape {
  double radius, half;
};
/// About the z axis, from -half to half.
struct CylinderShape {
  double radius, half;
};
/// Everything on the far side of z = 0: what is below is solid. It does not move.
struct HalfSpaceShape {};

/// Hulls, meshes and height fields are shared by whoever has the same.
using Geometry = std::variant<BallShape, BoxShape, CapsuleShape, CylinderShape, std::shared_ptr<const Hull>,
                              HalfSpaceShape, std::shared_ptr<const TriangleMesh>, std::shared_ptr<const HeightField>>;

/// Where a shape is: its axes to the world.
struct Pose {
  Vec3 x = zero3();
  Mat3 R = identity33();
  Vec3 to_world(Vec3 local) const { return x + R * local; }
  Vec3 to_local(Vec3 world) const { return transposed_times(R, world - x); }
};
inline Pose operator*(const Pose& outer, const Pose& inner) { return {outer.to_world(inner.x), outer.R * inner.R}; }

/// Turns the third axis, which capsules, cylinders and half spaces are about, to a direction of length 1.
Quat turn_to(Vec3 direction);

/// Whether it may be a body's: it has a volume, and each two of its points have the way between them in it.
bool is_convex(const Geometry& shape);
/// Whether things come through it from behind.
bool is_one_sided(const Geometry& shape);
/// Axis-aligned, in the world; of a half space infinite.
Bounds bounds_of(const Geometry& shape, const Pose& pose);
/// Radius about the shape's origin that all of it is within.
double reach_of(const Geometry& shape);
/// The smallest extent: what a gap is held against, and what may not be passed through in a step. Infinite of half spaces,
/// meshes and height fields, which are as solid behind their fronts as what meets them is thick.
double thickness_of(const Geometry& shape);

/// What of a turn or spin, in the world's axes, moves its surface: none of a ball's, none about the axis of what is round.
Vec3 turn_of(const Geometry& shape, const Pose& pose, Vec3 turn);

/// Throws Error where a length is not within 1e-12 m … 1e12 m, a convex shape is thinner than 1e-7 of its extent, or a shared
/// shape is missing.
void check_shape(const Geometry& shape);

/// Throw Error where something in what was read from a file leads out of it.
void check_read(const Hull& hull);
void check_read(const TriangleMesh& mesh);
void check_read(const HeightField& field);

/// A convex shape is a core widened by a radius: a point, a segment, a box, a hull or a cylinder.
double rounding_of(const Geometry& convex);
/// The point of the core farthest along a direction (0 allowed), in the shape's own axes.
Vec3 support_of_core(const Geometry& convex, Vec3 direction);

}  // namespace pantin
