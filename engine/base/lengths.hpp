#pragma once
#include "base/lanes.hpp"

namespace pantin {

/// The squared lengths of four vectors.
inline Vec3 lengths2(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  a *= a;
  b *= b;
  c *= c;
  d *= d;
  const Vec3 ab = __builtin_shufflevector(a, b, 0, 4, 2, 6) + __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Vec3 cd = __builtin_shufflevector(c, d, 0, 4, 2, 6) + __builtin_shufflevector(c, d, 1, 5, 3, 7);
  return __builtin_shufflevector(ab, cd, 0, 1, 4, 5) + __builtin_shufflevector(ab, cd, 2, 3, 6, 7);
}

}  // namespace pantin
