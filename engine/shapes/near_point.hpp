#pragma once
#include "shapes/core.hpp"

namespace pantin {

/// The point of a surface that is nearest to a point.
struct NearPoint {
  double distance;  ///< [m] below 0 inside
  Vec3 normal;      ///< outwards, of unit length
  Vec3 at;          ///< [m]
};

/// Of a point, a segment, a box or a cylinder, in its own axes; closed forms.
NearPoint near_point(const Core& core, Vec3 p);

}  // namespace pantin
