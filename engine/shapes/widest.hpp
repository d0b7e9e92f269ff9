#pragma once
#include "shapes/core.hpp"

namespace pantin {

/// Of two cores: the direction from b to a along which the gap between their shadows is widest.
struct Widest {
  Vec3 normal = vec(1, 0, 0);  ///< of unit length, axes of a
  double gap = -infinity;      ///< [m] below 0 where they overlap: then as deep as they do

  /// A direction that widens it by no more than `slack` [m] is not taken.
  void offer(Vec3 n, double along, double slack = 0.0) {
    if (along > gap + slack) gap = along, normal = n;
  }
};

/// Exact where cores overlap: no other direction has a wider gap. Of boxes the fifteen directions of Gottschalk, Lin and
/// Manocha (1996); of other polyhedra (one may be a point or a segment) those of faces, and of pairs of edges whose arcs
/// cross on Gauss's map (Gregorius 2013).
Widest widest_of_boxes(const CorePair& pair);
Widest widest_of_polyhedra(const CorePair& pair);

}  // namespace pantin
