#pragma once
// Convex shapes without their rounding, and two of them as one set of differences.
#include "shapes/hull.hpp"
#include "shapes/shape.hpp"

namespace pantin {

struct Core {
  enum class Kind : unsigned char { point, segment, box, cylinder, hull };
  Kind kind;
  Vec3 half;         ///< [m] of a box; (0, 0, half) of a segment; (radius, radius, half) of a cylinder
  const Hull* hull;  ///< where it is one
  double rounding;   ///< [m]
};
Core core_of(const Geometry& convex);

/// The point of a core farthest along a direction, in its own axes. Of several as far an end of them.
inline Vec3 support(const Core& core, Vec3 d) {
  switch (core.kind) {
    case Core::Kind::point: return zero3();
    case Core::Kind::segment: return d[2] < 0.0 ? -core.half : core.half;
    case Core::Kind::box: return d < 0.0 ? -core.half : core.half;
    case Core::Kind::cylinder: {
      const double across = std::sqrt(d[0] * d[0] + d[1] * d[1]), z = d[2] < 0.0 ? -core.half[2] : core.half[2];
      if (!(across > 0.0)) return vec(core.half[0], 0.0, z);
      return vec(core.half[0] * (d[0] / across), core.half[0] * (d[1] / across), z);
    }
    case Core::Kind::hull: return core.hull->vertices[farthest(*core.hull, d)];
  }
  return zero3();
}

/// A point of a, one of b, and their difference w = a - b.
struct Difference {
  Vec3 w, a, b;
};

/// Two cores in the axes of a.
struct CorePair {
  Core a, b;
  Mat3 R;  ///< axes of b to those of a
  Vec3 x;  ///< [m] origin of b

  Vec3 support_a(Vec3 d) const { return support(a, d); }
  Vec3 support_b(Vec3 d) const { return x + R * support(b, transposed_times(R, d)); }
  /// The difference that is least along n: n w is a lower bound of the distance if n has unit length.
  Difference lowest(Vec3 n) const {
    const Vec3 on_a = support_a(-n), on_b = support_b(n);
    return {on_a - on_b, on_a, on_b};
  }
};
CorePair core_pair(const Geometry& a, const Pose& at_a, const Geometry& b, const Pose& at_b);

}  // namespace pantin
