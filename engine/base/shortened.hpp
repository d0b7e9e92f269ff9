#pragma once
#include <cmath>

#include "base/lanes.hpp"

namespace pantin {

/// Takes round-off out of a number that was a short one: twelve digits of what has that size stay.
inline double shortened(double x, double size) {
  constexpr double digits = 1e11, most = 1e22;  // greater powers of ten are no doubles
  if (!(size > 0.0) || size >= 10.0 * digits) return x;
  double scale = 1.0;
  while (size * scale < digits && scale < most) scale *= 10.0;
  return std::round(x * scale) / scale;
}
inline Vec3 shortened(Vec3 v, double size) {
  for (int i = 0; i < 3; i++) v[i] = shortened(static_cast<double>(v[i]), size);
  return v;
}

}  // namespace pantin
