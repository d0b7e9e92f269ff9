#pragma once
#include "shapes/shape.hpp"

namespace pantin {

/// Of a convex shape filled evenly.
struct SolidMass {
  double volume = 0.0;     ///< [m³]
  Vec3 centre = zero3();   ///< [m]
  Mat3 second = zero33();  ///< [m⁵] inertia of density 1 about the centre, in the shape's axes
};
/// Closed forms; of hulls by Mirtich (1996).
SolidMass solid_mass(const Geometry& convex);

}  // namespace pantin
