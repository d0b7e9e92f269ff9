#pragma once
#include "shapes/widest.hpp"

namespace pantin {

struct Expanded {
  Widest widest;
  bool settled;  ///< no direction has a gap wider by more than was accepted
};

/// The expanding polytope of van den Bergen (2001): how deep cores overlap, to within `accepted` [m]. From any tetrahedron:
/// the origin need not be in it. Ends unsettled where faces get too thin or too many.
Expanded expand(const CorePair& pair, Vec3 start, double accepted);

}  // namespace pantin
