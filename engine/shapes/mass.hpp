#pragma once
#include "shapes/shape.hpp"

namespace pantin {

/// Of a convex shape filled evenly.
struct SolidMass {
  double volume = 0.0;     ///< [m³]
  Vec3 centre = zero3();   ///< [m]
  Mat3 second = zero33();  ///< [m⁵] inertia of density 1 about the centre, in the shape's axes
};
/// Closed forms; of hulls sums over tetrahedra (Tonon 2004). Throws Error of what does not move.
SolidMass solid_mass(const Geometry& convex);

}  // namespace pantin
