#pragma once
// The part of a convex shape that lies farthest along a direction, as what meets that of another shape.
#include <algorithm>
#include <array>

#include "shapes/core.hpp"

namespace pantin {

/// Sine of the angle between a cylinder's axis and a normal, below which it lies on its end, and above which on one point of its
/// rim, which keeps its name wherever on the rim that is.
inline constexpr double lies_on_end = 0.02;

struct Corner {
  Vec3 x;              ///< [m] world axes
  std::uint32_t name;  ///< of the corner, the same from step to step
  std::uint32_t edge;  ///< name of the edge that begins there
};

/// Corners of a polygon that is not named by a type: what clipping works on.
struct Loop {
  static constexpr std::uint32_t capacity = 128;
  std::uint32_t count = 0;
  bool closed = false;
  std::array<Corner, capacity> corners;

  Loop() = default;
  Loop(const Loop& other) { *this = other; }
  /// Corners past the count are not copied.
  Loop& operator=(const Loop& other) {
    count = other.count;
    closed = other.closed;
    std::copy_n(other.corners.begin(), count, corners.begin());
    return *this;
  }
  void add(const Corner& corner) {
    if (count < capacity) corners[count++] = corner;
  }
};

/// Of a shape's surface: a face, the cap of a cylinder, a line along the side of a capsule or a cylinder, or a point.
struct Feature {
  enum class Kind : unsigned char { point, segment, polygon, disc };
  Kind kind;
  Vec3 normal;               ///< outwards, of a polygon or a disc
  std::uint32_t number;      ///< of the face
  Loop loop;                 ///< anticlockwise from outside; points on the rim of a disc
  Vec3 centre;               ///< [m] of a disc
  double radius;             ///< [m] of a disc; of a segment about `line`
  std::array<Vec3, 2> line;  ///< [m] ends of the line that a segment is within `radius` of
  bool is_face() const { return kind == Kind::polygon || kind == Kind::disc; }
};

/// The feature whose normal is nearest to a direction of unit length (world), of equals the first. Faces of hulls with more
/// than 64 corners are told without some of them.
void find_feature(const Core& core, const Pose& pose, Vec3 along, Feature& feature);
/// A face of a hull by its number.
void find_face(const Hull& hull, const Pose& pose, std::uint32_t number, Feature& feature);

/// One number of several, below 2^31.
std::uint32_t name_of(std::uint32_t kind, std::uint32_t first, std::uint32_t second, std::uint32_t third = 0);

}  // namespace pantin
