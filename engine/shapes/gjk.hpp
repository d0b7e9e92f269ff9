#pragma once
#include "shapes/simplex.hpp"

namespace pantin {

/// How two cores lie, in the axes of a.
struct Nearness {
  enum class Found : unsigned char { apart, beyond, overlapping };
  Found found;
  Vec3 normal;      ///< from b to a, of unit length
  double distance;  ///< [m] of cores that are apart; a lower bound where they are beyond what was asked for
  Simplex simplex;
};

/// Gilbert, Johnson and Keerthi (1988) from a direction from b to a, of any length > 0. Exact for polyhedra; of cylinders
/// within 1e-10 of their size. Cores that touch may be told as overlapping. Past `beyond` [m] it ends at once.
Nearness nearness(const CorePair& pair, Vec3 start, double beyond);

/// Radius about the origin of a core [m].
double size_of(const Core& core);

}  // namespace pantin
